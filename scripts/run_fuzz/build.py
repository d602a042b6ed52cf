"""The build of the fuzz targets."""
import os
import pathlib
import shutil
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[2]
BUILD = pathlib.Path(os.environ.get('FRONTIER_PILOT_FUZZ_BUILD') or ROOT / 'build' / 'fuzz')
OPTIONS = ('-DWITH_ROS=OFF', '-DWITH_TESTS=OFF', '-DWITH_BENCHMARKS=OFF', '-DWITH_FUZZERS=ON', '-DCMAKE_BUILD_TYPE=None',
           '-DCMAKE_CXX_COMPILER=clang++', '-DCMAKE_DISABLE_FIND_PACKAGE_catkin=ON')


class BuildError(Exception):
    """A target cannot be built; says why."""


def run(what, words):
    log = BUILD / (what + '.log')
    with log.open('w') as out:
        code = subprocess.run(words, stdout=out, stderr=subprocess.STDOUT, cwd=ROOT).returncode
    text = log.read_text(errors='replace')
    if code != 0 and 'needs clang' in text:
        raise BuildError(missing())
    if code != 0:
        raise BuildError('cannot %s; the end of %s:\n%s' % (what, log, '\n'.join(text.splitlines()[-20:])))


def missing():
    return 'clang with libFuzzer is missing: scripts/setup installs it'


def make(names):
    """Builds these targets."""
    if shutil.which('clang++') is None:
        raise BuildError(missing())
    BUILD.mkdir(parents=True, exist_ok=True)
    print('building %s in %s ...' % (', '.join(names), BUILD), flush=True)
    run('configure', ['cmake', '-S', str(ROOT), '-B', str(BUILD), '-G', 'Ninja', *OPTIONS])
    run('build', ['cmake', '--build', str(BUILD), '-j', str(os.cpu_count()), '--target', *('fuzz_' + name for name in names)])


def program(name):
    return BUILD / 'bin' / ('fuzz_' + name)
