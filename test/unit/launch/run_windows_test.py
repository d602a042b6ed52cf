#!/usr/bin/env python3
"""scripts/run with programs in place of the nodes and of the watcher: when it saves the map, and where it does not begin."""
import os
import pathlib
import shutil
import signal
import socket
import subprocess
import tempfile
import time
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[3]
WATCHER = '''#!/bin/bash
trap 'echo saved again >>"$WATCHED"; exit 143' TERM
dies() { [[ $KILLED = twice && " $* " == *' --save-at-end '* ]]; }
! dies "$@" || trap '' TERM
echo "$@" >>"$WATCHED"
! dies "$@" || kill -KILL $$
for ((i = 0; i < EXPLORES; i++)); do sleep 0.05; done
[[ " $* " != *' --save-now '* ]] || exit 0
[ -z "$KILLED" ] || [[ " $* " == *' --sav'* ]] || kill -KILL $$
[[ " $* " == *' --saved-already '* || " $* " == *' --save-at-end '* ]] || exit "$WATCHER_CODE"  # the exploration is done
while :; do sleep 0.05; done
'''
FAILING_LAUNCH = '() { echo "RLException: run_id on parameter server does not match declared run_id: 1 vs 2"; return 1; }'
LAUNCH = '() { trap "exit 0" INT; echo "$@" >"$LAUNCHED"; while [ ! -e "$LAUNCH_ENDS" ]; do sleep 0.05; done; cat "$LAUNCH_ENDS"; }'
# What roslaunch and the nodes say when a process has died that all need.
DEATH = '''[navigator-4] process has died [pid 7, exit code -9, cmd navigator].
\x1b[31m%sREQUIRED process [%s] has died!
process has died [pid 8, exit code -9, cmd simulator].
Initiating shutdown!
%s\x1b[0m
run_recorder: recorded 3.5 MB in /runs/one
[ WARN] [1.0] [/mapper]: the map was not saved, because of this; its copy is kept: map_file:=/lost/map.yaml begins with it
\x1b[1mdone\x1b[0m
'''


class RunWindows(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        with socket.socket() as probe:
            probe.bind(('127.0.0.1', 0))
            self.master = 'http://127.0.0.1:%d' % probe.getsockname()[1]
        scripts, build, self.caller = self.folder / 'root/scripts', self.folder / 'build', self.folder / 'caller'
        for made in scripts, build / 'devel', self.caller, self.folder / 'root/launch':
            made.mkdir(parents=True)
        for name in 'run', 'command_line.sh', 'launch_arguments.sh', 'surroundings.sh', 'up_to_date_build.sh':
            shutil.copy(ROOT / 'scripts' / name, scripts / name)
        shutil.copy(ROOT / 'launch/system.launch', self.folder / 'root/launch')
        for name, text in (('setup', ''), ('running_system.py', ''), ('report', 'echo /report.html'), ('bounded_log.py', 'cat >"$1"'),
                           ('watch_exploration.py', WATCHER)):
            (scripts / name).write_text(text if text.startswith('#!') else '#!/bin/bash\n' + text + '\n')
            (scripts / name).chmod(0o755)
        for name in 'CMakeCache.txt', 'build.ninja', 'devel/setup.bash':
            (build / name).write_text('')
        self.watched, self.launch_ends = self.folder / 'watched', self.folder / 'launch_ends'

    def start(self, *words, display=':9', launch=LAUNCH, explores=0, code=0, killed=''):
        environment = dict(os.environ, FRONTIER_PILOT_BUILD=str(self.folder / 'build'), DISPLAY=display, WATCHED=str(self.watched),
                           ROS_HOME=str(self.folder / 'home'), ROS_PACKAGE_PATH='', ROS_MASTER_URI=self.master, LAUNCHED=str(self.folder / 'launched'), HOME=str(self.folder),
                           LAUNCH_ENDS=str(self.launch_ends), EXPLORES=str(explores), WATCHER_CODE=str(code), KILLED=killed, **{'BASH_FUNC_roslaunch%%': launch, 'BASH_FUNC_cmake%%': '() { touch "$WATCHED"; }'})
        process = subprocess.Popen([str(self.folder / 'root/scripts/run'), *words], cwd=self.caller, env=environment, text=True,
                                   stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE, start_new_session=True,
                                   preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL))
        self.addCleanup(self.end, process)
        return process

    def end(self, process):
        self.launch_ends.touch()
        if process.poll() is None:
            process.send_signal(signal.SIGINT)  # killed, it would leave the watcher, which holds its output
        process.communicate(timeout=60)

    def start_until_done(self, *words, record='false', code=0, killed=''):
        process = self.start('record:=' + record, *words, code=code, explores=20 if killed else 0, killed=killed)
        for line in process.stdout:
            if line.startswith('Launching; '):
                self.logs = pathlib.Path(line.split(' goes to ')[1].split(',')[0]).parent
            if line.startswith('The system runs on'):
                self.outlook = line
                break
        end = time.monotonic() + 30.0
        while self.watched.read_text().count('--map') < 2 and time.monotonic() < end:
            time.sleep(0.05)
        return process

    def test_ctrl_c_after_the_exploration_saves_what_was_mapped_since(self):
        process = self.start_until_done('map:=floor')
        process.send_signal(signal.SIGINT)
        _, err = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 130, err)
        map_option = '--map %s/floor' % self.caller
        self.assertEqual(self.watched.read_text().splitlines(), [map_option, map_option + ' --saved-already', 'saved again'])

    def test_ctrl_c_saves_what_could_not_be_saved_after_the_exploration(self):
        """[FLT-2]"""
        process = self.start_until_done('map:=floor', code=3)
        self.assertIn('tries again to save the map, which is saved nowhere yet', self.outlook)
        process.send_signal(signal.SIGINT)
        _, err = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 130, err)
        map_option = '--map %s/floor' % self.caller
        self.assertEqual(self.watched.read_text().splitlines(), [map_option, map_option + ' --save-at-end', 'saved again'])

    def test_the_map_is_saved_although_a_watcher_was_killed(self):
        """[FLT-2]"""
        map_option = '--map %s/floor' % self.caller
        for killed, at_the_end in (('once', 'saved again'), ('twice', map_option + ' --save-now')):
            with self.subTest(killed=killed):
                self.watched.write_text('')
                process = self.start_until_done('map:=floor', killed=killed)
                self.assertIn('tries again to save the map, which is saved nowhere yet', self.outlook)
                process.send_signal(signal.SIGINT)
                _, err = process.communicate(timeout=60)
                self.assertEqual(process.returncode, 130, err)
                self.assertEqual(self.watched.read_text().splitlines(), [map_option, map_option + ' --save-at-end', at_the_end], err)

    def test_the_map_is_saved_although_the_watcher_of_a_run_without_windows_was_killed(self):
        """[FLT-2]"""
        process = self.start('map:=floor', 'gui:=false', 'rviz:=false', 'record:=false', display='', explores=20, killed='once')
        _, err = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 1)
        self.assertEqual(self.watched.read_text().splitlines()[1:], ['--map %s/floor --save-now' % self.caller])
        self.assertIn('scripts/run: what watches the exploration was killed; saving the map in its place ...', err)

    def test_a_map_that_could_not_be_saved_is_a_failure_of_the_run(self):
        process = self.start('map:=floor', 'gui:=false', 'rviz:=false', 'record:=false', display='', code=3)
        self.launch_ends.touch()
        process.communicate(timeout=60)
        self.assertEqual(process.returncode, 1)

    def test_a_value_may_begin_with_the_home_folder(self):
        (self.folder / 'maps of today').mkdir()
        process = self.start_until_done('map:=~/maps of today/floor')
        process.send_signal(signal.SIGINT)
        process.communicate(timeout=60)
        self.assertIn('--map %s/maps of today/floor' % self.folder, self.watched.read_text().splitlines())

    def test_the_name_of_a_saved_map_may_look_like_a_number(self):
        for name, handed_on in (('007', './007'), ('/007', '/007'), ('none', 'none')):
            (self.caller / '007.yaml').write_text('')
            words = ('map_file:=%s%s' % (self.caller if name[0] == '/' else '', name), 'map:=floor')
            process = self.start_until_done(*words)
            process.send_signal(signal.SIGINT)
            process.communicate(timeout=60)
            said = (self.folder / 'launched').read_text()
            self.assertIn('map_file:=%s%s ' % (self.caller if name[0] == '/' else '', handed_on), said.strip() + ' ')

    def test_ctrl_z_does_not_leave_a_robot_that_drives_on(self):
        """[FLT-1]"""
        process = self.start_until_done('map:=floor')
        status = pathlib.Path('/proc/%d/status' % process.pid).read_text()
        process.send_signal(signal.SIGINT)
        process.communicate(timeout=60)
        ignored = int(status.split('SigIgn:')[1].split()[0], 16)
        self.assertTrue(ignored >> (signal.SIGTSTP - 1) & 1)

    def test_says_how_a_report_is_made_if_its_folder_was_removed(self):
        process = self.start_until_done('map:=floor', record='true')
        shutil.rmtree(self.logs)
        process.send_signal(signal.SIGINT)
        _, err = process.communicate(timeout=60)
        self.assertIn('somebody has removed %s; ' % self.logs, err)
        self.assertNotIn('before its recorder had begun', err)

    def test_says_that_another_launch_has_begun_at_the_same_master(self):
        process = self.start('record:=false', launch=FAILING_LAUNCH, explores=200)
        _, err = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 1)
        self.assertRegex(err.splitlines()[-1], '^scripts/run: a launch that has begun at the same moment, or another program, has the port')

    def test_a_launch_that_ends_by_itself_after_the_exploration_leaves_no_watcher(self):
        process = self.start_until_done()
        self.launch_ends.touch()
        _, err = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 1, err)
        self.assertNotIn('saved again', self.watched.read_text())

    def test_a_launch_that_ends_by_itself_after_the_exploration_is_a_failure_whose_reason_is_said(self):
        """[FLT-2]"""
        for died in 'simulator-2', 'master':
            with self.subTest(died=died):
                self.watched.write_text('')
                process = self.start_until_done()
                (self.folder / 'said').write_text(DEATH % (80 * '=', died, 80 * '='))
                (self.folder / 'said').rename(self.launch_ends)
                _, err = process.communicate(timeout=60)
                self.launch_ends.unlink()
                self.assertEqual(process.returncode, 1, err)
                kept, ended, why = err.splitlines()[-3:]
                self.assertRegex(kept, '^scripts/run: the map was not saved, because of this; .* map_file:=/lost/map.yaml begins with it$')
                self.assertRegex(ended, '^The launch ended by itself; all output of the nodes is in ')
                self.assertEqual(why, 'scripts/run: REQUIRED process [%s] has died!' % died)

    def test_a_folder_in_which_the_map_could_not_be_saved_is_refused_before_anything_is_built(self):
        """[FLT-1]"""
        (self.caller / 'maps').write_text('')
        for words in (), ('map:=',), ('map:=floor', 'map:='):
            process = self.start(*words)
            out, err = process.communicate(timeout=60)
            self.assertEqual((process.returncode, out), (2, ''))
            self.assertRegex(err, '^scripts/run: map: nothing can be written to the folder .*/maps, where the map would be saved; give '
                                  'another path with map:=PATH; .*\n$')
            self.assertFalse(self.watched.exists(), 'it was built')

    def test_the_folder_of_a_map_is_not_made(self):
        process = self.start('map:=%s/nowhere/floor' % self.folder)
        out, err = process.communicate(timeout=60)
        self.assertEqual((process.returncode, out), (2, ''))
        self.assertRegex(err, "^scripts/run: map: there is no folder '.*/nowhere'; make it first, or give another path; .*\n$")
        self.assertFalse((self.folder / 'nowhere').exists())

    def test_a_folder_of_maps_does_not_matter_if_the_map_is_saved_elsewhere(self):
        (self.caller / 'maps').write_text('')
        process = self.start_until_done('map:=floor')
        process.send_signal(signal.SIGINT)
        process.communicate(timeout=60)
        self.assertEqual(process.returncode, 130)


if __name__ == '__main__':
    unittest.main()
