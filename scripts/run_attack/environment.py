"""The environment that the attack and all it starts run in: that of the build, on the loopback interface only."""
import os
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
ENTERED = 'FRONTIER_PILOT_ATTACK_BUILD'  # is in the environment once it is that of a build


class NoBuild(Exception):
    """There is nothing that could be attacked."""


def find_build():
    """The folder of a build that has the nodes."""
    named = [os.environ[name] for name in ('FRONTIER_PILOT_BUILD', 'FRONTIER_PILOT_TEST_BUILD') if os.environ.get(name)]
    folders = [pathlib.Path(name) for name in named] or [ROOT / 'build', ROOT / 'build' / 'test']
    for folder in folders:
        if (folder / 'devel/setup.bash').exists() and (folder / 'devel/lib/frontier_pilot/cmd_vel_arbiter').exists():
            return folder
    raise NoBuild('no build in %s; scripts/run and scripts/test make one' % ' or '.join(map(str, folders)))


def sourced(build):
    """The environment after the setup script of a build was sourced."""
    words = subprocess.run(['bash', '-c', '. "$1/devel/setup.bash" && env -0', 'bash', str(build)], check=True,
                           stdout=subprocess.PIPE).stdout.split(b'\0')
    pairs = [os.fsdecode(word).split('=', 1) for word in words if b'=' in word]
    environment = dict(pair for pair in pairs if not pair[0].startswith('BASH_FUNC'))
    environment['ROS_PACKAGE_PATH'] += ':/usr/share'  # where Debian's ROS packages are
    environment['PATH'] = '/usr/bin:' + environment['PATH']
    for name in ('ROS_HOSTNAME', 'ROS_NAMESPACE', 'ROS_MASTER_URI', 'ROS_LOG_DIR'):
        environment.pop(name, None)
    environment.update(ROS_IP='127.0.0.1', LC_ALL='C.UTF-8', QT_QPA_PLATFORM='offscreen', PYTHONDONTWRITEBYTECODE='1')
    return environment


def enter_build():
    """Starts this program again in the environment of a build, with the system's Python; returns where that has happened."""
    if os.environ.get(ENTERED):
        return
    build = find_build()
    environment = sourced(build)
    environment[ENTERED] = str(build)
    os.execve('/usr/bin/python3', ['/usr/bin/python3'] + sys.argv, environment)
