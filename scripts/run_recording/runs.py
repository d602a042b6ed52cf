"""The folder in which recorded runs are kept: each in a folder of its own, named by the date and time of its start."""
import datetime
import os
import re
import shutil

BAG = 'run'  # rosbag adds the number of the part
NAME = re.compile(r'^\d{4}-\d\d-\d\d_\d\d-\d\d-\d\d(_\d+)?$')
PART = re.compile(r'^%s_(?:(\d+)_)?(\d+)\.bag(\.active)?$' % BAG)  # the number of the stretch, unless it is the first, and of the part


def default_folder():
    """ROS_HOME/frontier_pilot/runs."""
    ros_home = os.environ.get('ROS_HOME') or os.path.join(os.path.expanduser('~'), '.ros')
    return os.path.join(ros_home, 'frontier_pilot', 'runs')


def all_runs(folder):
    """The folders of the recorded runs, the oldest one first."""
    try:
        names = sorted(name for name in os.listdir(folder) if NAME.match(name))
    except FileNotFoundError:
        return []
    paths = [os.path.join(folder, name) for name in names]
    return [path for path in paths if os.path.isdir(path) and not os.path.islink(path)]


def begin(folder, now=None):
    """Creates the folder of a new run and returns its path. Throws OSError."""
    name = (now or datetime.datetime.now()).strftime('%Y-%m-%d_%H-%M-%S')
    os.makedirs(folder, exist_ok=True)
    for copy in range(100):
        path = os.path.join(folder, name + ('_%d' % copy if copy else ''))
        try:
            os.mkdir(path)
            return path
        except FileExistsError:
            pass
    raise FileExistsError('%s and a hundred more of this name exist already' % os.path.join(folder, name))


def keep_newest(folder, count, spared=()):
    """Removes all runs but the newest `count`; never those in `spared`, nor one that is still being recorded. Returns what
    was removed."""
    removed = []
    for path in all_runs(folder)[:-count or None]:
        if path not in spared and not is_being_recorded(path):
            shutil.rmtree(path, ignore_errors=True)
            removed.append(path)
    return removed


def bag_of(run, stretch):
    """What rosbag is told to write. Each time that it is started in the same run it writes a stretch of its own, because it
    numbers its parts from zero. The first stretch has the number 1."""
    return os.path.join(run, BAG + ('_%d' % stretch if stretch > 1 else ''))


def stretch_of(part):
    """The number of the stretch to which a bag belongs; 1 for one that the recorder has not written."""
    match = PART.match(os.path.basename(part))
    return int(match.group(1) or 1) if match else 1


def parts_of(run):
    """The bags of a run in the order in which they were written. One that is open or was not closed ends with .active, which
    can be the last one of each stretch."""
    names = [(int(match.group(1) or 1), int(match.group(2)), match.group(0)) for match in map(PART.match, os.listdir(run)) if match]
    return [os.path.join(run, name) for _, _, name in sorted(names)]


def is_being_recorded(run):
    """Whether a process has an open part of this run."""
    return any(is_open(part) for part in parts_of(run) if part.endswith('.active'))


def is_open(path):
    """Whether a process has this file open."""
    path = os.path.realpath(path)
    return any(path == link for process in filter(str.isdigit, os.listdir('/proc')) for link in _open_files(process))


def _open_files(process):
    folder = '/proc/%s/fd' % process
    try:
        numbers = os.listdir(folder)
    except OSError:  # it has ended, or belongs to somebody else
        return
    for number in numbers:
        try:
            yield os.readlink(os.path.join(folder, number))
        except OSError:
            pass
