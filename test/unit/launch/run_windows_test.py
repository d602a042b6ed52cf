#!/usr/bin/env python3
"""scripts/run with programs in place of the nodes and of the watcher: when it saves the map, and where it does not begin."""
import os
import pathlib
import shutil
import signal
import subprocess
import tempfile
import time
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[3]
WATCHER = '''#!/bin/bash
trap 'echo saved again >>"$WATCHED"; exit 143' TERM
echo "$@" >>"$WATCHED"
[[ " $* " == *' --saved-already '* ]] || exit 0  # the exploration is done
while :; do sleep 0.05; done
'''
LAUNCH = '() { trap "exit 0" INT; touch "$LAUNCHED"; while [ ! -e "$LAUNCH_ENDS" ]; do sleep 0.05; done; }'


class RunWindows(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        scripts, build, self.caller = self.folder / 'root/scripts', self.folder / 'build', self.folder / 'caller'
        for made in scripts, build / 'devel', self.caller, self.folder / 'root/launch':
            made.mkdir(parents=True)
        for name in 'run', 'command_line.sh', 'launch_arguments.sh':
            shutil.copy(ROOT / 'scripts' / name, scripts / name)
        shutil.copy(ROOT / 'launch/system.launch', self.folder / 'root/launch')
        for name, text in (('setup', ''), ('running_system.py', ''), ('report', 'echo /report.html'), ('bounded_log.py', 'cat >"$1"'),
                           ('watch_exploration.py', WATCHER)):
            (scripts / name).write_text(text if text.startswith('#!') else '#!/bin/bash\n' + text + '\n')
            (scripts / name).chmod(0o755)
        for name in 'CMakeCache.txt', 'build.ninja', 'devel/setup.bash':
            (build / name).write_text('')
        self.watched, self.launch_ends = self.folder / 'watched', self.folder / 'launch_ends'

    def start(self, *words, display=':9'):
        environment = dict(os.environ, FRONTIER_PILOT_BUILD=str(self.folder / 'build'), DISPLAY=display, WATCHED=str(self.watched),
                           ROS_HOME=str(self.folder / 'home'), ROS_PACKAGE_PATH='', LAUNCHED=str(self.folder / 'launched'),
                           LAUNCH_ENDS=str(self.launch_ends), **{'BASH_FUNC_roslaunch%%': LAUNCH, 'BASH_FUNC_cmake%%': '() { touch "$WATCHED"; }'})
        process = subprocess.Popen([str(self.folder / 'root/scripts/run'), *words], cwd=self.caller, env=environment, text=True,
                                   stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE, start_new_session=True,
                                   preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL))
        self.addCleanup(self.end, process)
        return process

    def end(self, process):
        self.launch_ends.touch()
        if process.poll() is None:
            process.kill()
        process.communicate()

    def start_until_done(self, *words):
        process = self.start('record:=false', *words)
        for line in process.stdout:
            if line.startswith('The windows stay open'):
                break
        end = time.monotonic() + 30.0
        while '--saved-already' not in self.watched.read_text() and time.monotonic() < end:
            time.sleep(0.05)
        return process

    def test_ctrl_c_after_the_exploration_saves_what_was_mapped_since(self):
        process = self.start_until_done('map:=floor')
        process.send_signal(signal.SIGINT)
        _, err = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 130, err)
        map_option = '--map %s/floor' % self.caller
        self.assertEqual(self.watched.read_text().splitlines(), [map_option, map_option + ' --saved-already', 'saved again'])

    def test_a_launch_that_ends_by_itself_after_the_exploration_leaves_no_watcher(self):
        process = self.start_until_done()
        self.launch_ends.touch()
        _, err = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 0, err)
        self.assertNotIn('saved again', self.watched.read_text())

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

    def test_a_folder_of_maps_does_not_matter_if_the_map_is_saved_elsewhere(self):
        (self.caller / 'maps').write_text('')
        process = self.start_until_done('map:=floor')
        process.send_signal(signal.SIGINT)
        process.communicate(timeout=60)
        self.assertEqual(process.returncode, 130)


if __name__ == '__main__':
    unittest.main()
