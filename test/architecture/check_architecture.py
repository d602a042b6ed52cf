#!/usr/bin/env python3
"""Checks what no compiler does: the arrows between the folders, the sizes, the names, the cited requirements.

Usage: check_architecture.py [ROOT]. Prints one line for each problem; exit code 0 if there is none.
"""
import collections
import pathlib
import re
import statistics
import sys

from cpp_functions import code_of, functions_of

# What a folder under src/ may include of the project besides itself: the arrows of docs/architecture.md. '*' is everything.
MAY_INCLUDE = {
    'core': set(),
    'grids': {'core'},
    'sim': {'core', 'grids', 'map_files'},
    'logs': {'core'},
    'arbiter': {'core'},
    'avoid': {'core'},
    'patrol': {'core'},
    'behavior': {'core', 'grids'},
    'teleop': {'core'},
    'waypoints': {'core'},
    'surfaces': {'core'},
    'scan_matching': {'core', 'grids', 'surfaces'},
    'occupancy': {'core', 'grids', 'surfaces'},
    'slam': {'core', 'grids', 'surfaces', 'scan_matching', 'occupancy'},
    'localization': {'core', 'grids', 'surfaces', 'scan_matching', 'occupancy', 'slam'},
    'mapping': {'core', 'grids', 'surfaces', 'scan_matching', 'occupancy', 'slam', 'localization'},
    'map_files': {'core', 'occupancy'},
    'planning': {'core', 'grids'},
    'navigation': {'core', 'grids', 'planning'},
    'exploration': {'core', 'grids'},
    'fleet': {'core', 'grids', 'surfaces', 'scan_matching', 'exploration', 'navigation'},
    'system': {'core', 'sim', 'arbiter', 'behavior', 'mapping', 'occupancy', 'navigation', 'exploration', 'fleet'},
    'robot_check': {'core'},
    'tools': {'core', 'logs', 'mapping', 'occupancy', 'slam', 'map_files'},
    'gui': {'core', 'teleop'},
    'ros': {'*'},
    'nodes': {'*'},
    'rviz': {'*'},
}
# Programs: nobody builds upon them, so all their headers lie beside their sources; who may include those.
PROGRAMS = {'tools': {'ros', 'nodes'}, 'waypoints': {'ros', 'nodes'}, 'robot_check': {'ros', 'nodes'}, 'teleop': {'gui', 'ros', 'rviz', 'nodes'}, 'gui': {'nodes', 'rviz'}, 'ros': {'nodes', 'rviz'}, 'nodes': set(), 'rviz': set()}
SEES_ROS = {'ros', 'nodes', 'rviz'}
MAY_PRINT = SEES_ROS | {'tools'}
# Modules that other packages use and this one does not need to.
FOR_OTHERS = {'system'}
# Whose headers these are, and the folders that may include them.
FOREIGN = (
    ('ROS', re.compile(r'^(ros|ros[a-z]+|tf2?|tf2_\w+|actionlib|diagnostic_updater|pluginlib|rviz|xmlrpcpp|message_filters|'
                       r'\w+_msgs|std_srvs|topic_tools|dynamic_reconfigure)/|^frontier_pilot/[A-Z]\w*\.h$'), SEES_ROS),
    ('OMPL', re.compile(r'^ompl/'), {'planning'}),
    ('OctoMap', re.compile(r'^octomap/'), {'occupancy'}),
    ('Qt', re.compile(r'^Q[A-Z]|^Qt\w+/'), {'gui', 'rviz', 'nodes', 'ros'}),
)
IMPURE = re.compile(r'::now\((?!\) const)|\bsleep_(for|until)\(|\bu?sleep\(|\bnanosleep\(|\bgettimeofday\(|\bclock_gettime\(|'
                    r'\brandom_device\b|\bstd::(cout|cerr|clog)\b|\bf?printf\(')
MAY_WAIT = {'src/map_files/folder_lock.cpp'}  # for the lock of another process, as any read waits for the disk
LITERAL_NAME = re.compile(r'\b(advertise|advertiseService|subscribe|serviceClient|call|waitForService|SimpleActionServer|'
                          r'SimpleActionClient)\s*(<[^;{}]*?>)?\s*\w*\s*[({][^;"]*?"[^"]*"')
# roscpp reads a message without checks, and logs each one that it cannot read.
UNCHECKED_SUBSCRIPTION = re.compile(r'\b(?:node|\w*_node|node_|nh_?|n)\.subscribe\s*(?:<[^;{}()]*>)?\s*\((?!options\))|'
                                    r'ros::NodeHandle\([^()]*\)\.subscribe\b')
FRAME = re.compile(r'"(map|odom|base_footprint|base_link|base_scan|world)"')
MAX_FILE, MAX_ADAPTER, MAX_MAIN, MAX_FUNCTION = 300, 150, 25, 60
MAX_UNITS = 15
MAX_PUBLIC_HEADERS = 75


def folder_of(path, root):
    """The folder that counts as the module of a source file: include/frontier_pilot/X/..., src/X/..."""
    parts = path.relative_to(root).parts
    return parts[2] if parts[0] == 'include' else parts[1]


def sources(root, *folders):
    for folder in folders:
        for pattern in ('*.h', '*.cpp'):
            yield from sorted((root / folder).rglob(pattern))


def house(root):
    for path in sources(root, 'include/frontier_pilot', 'src'):
        yield path, folder_of(path, root)


def includes_of(text):
    return re.findall(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]', text, re.MULTILINE)


def check_arrows(root):
    for path, folder in house(root):
        allowed = MAY_INCLUDE.get(folder)
        if allowed is None:
            yield path, 'folder %s is not part of the house' % folder
            continue
        for include in includes_of(path.read_text()):
            own = re.match(r'^frontier_pilot/(\w+)/', include)
            if '..' in include:
                yield path, 'includes %s: reaches into another folder' % include
            elif own and own.group(1) != folder and '*' not in allowed and own.group(1) not in allowed:
                yield path, 'includes %s: %s may only use %s' % (include, folder, ', '.join(sorted(allowed)))
            private = re.match(r'^(\w+)/\S+\.h$', include)
            owner_of_private = private.group(1) if private and (root / 'src' / include).exists() else folder
            if owner_of_private != folder and folder not in PROGRAMS.get(owner_of_private, set()):
                yield path, 'includes %s: a private header of %s' % (include, owner_of_private)
            for owner, pattern, homes in FOREIGN:
                if pattern.search(include) and folder not in homes:
                    yield path, 'includes %s: %s belongs to %s' % (include, owner, ', '.join(sorted(homes)))


def check_purity(root):
    for path, folder in house(root):
        if folder in MAY_PRINT or str(path.relative_to(root)) in MAY_WAIT:
            continue
        for match in IMPURE.finditer(code_of(path.read_text())):
            yield path, 'reads a clock, sleeps, prints or is not deterministic: %s' % match.group(0)


def limit_of(path, root):
    relative = str(path.relative_to(root))
    if re.match(r'src/nodes/\w+_node\.cpp$', relative):
        return MAX_MAIN
    return MAX_ADAPTER if path.stem.endswith('_adapter') else MAX_FILE


def check_sizes(root):
    for path in sources(root, 'include', 'src', 'test', 'bench'):
        lines = path.read_text().count('\n')
        if lines >= limit_of(path, root):
            yield path, 'has %d lines, %d is the limit' % (lines, limit_of(path, root))
    for path in sources(root, 'include', 'src'):
        for name, length in functions_of(path.read_text()):
            if length > MAX_FUNCTION:
                yield path, 'function %s has %d lines, %d is the limit' % (name, length, MAX_FUNCTION)


def check_rooms(root):
    """Folders hold what a reader can take in, and a header is public only where another module includes it."""
    for folder in sorted(path for path in (root / 'src').rglob('*') if path.is_dir()):
        units = {path.stem for path in folder.iterdir() if path.suffix in ('.h', '.cpp')}
        if len(units) > MAX_UNITS:
            yield folder, 'holds %d units, %d is the limit' % (len(units), MAX_UNITS)
    public = list(sources(root, 'include'))
    if len(public) > MAX_PUBLIC_HEADERS:
        yield root / 'include', 'holds %d public headers, %d is the limit' % (len(public), MAX_PUBLIC_HEADERS)
    included = collections.defaultdict(set)  # header: the folders that include it, and public headers that do
    for path, folder in house(root):
        for include in includes_of(path.read_text()):
            included[include].add('public' if 'include' in path.relative_to(root).parts[0] else folder)
    for path in public:
        users = included[str(path.relative_to(root / 'include'))] - {folder_of(path, root)}
        if not users and folder_of(path, root) not in FOR_OTHERS:
            yield path, 'is public, and nothing outside its module includes it'


def check_names(root):
    for path, folder in house(root):
        if folder not in SEES_ROS or path.name == 'names.h':
            continue
        text = code_of(path.read_text(), keep_strings=True)
        for pattern in (LITERAL_NAME, FRAME):
            for match in pattern.finditer(text):
                yield path, 'a name that belongs into ros/common/names.h: %s' % ' '.join(match.group(0).split())


def check_subscriptions(root):
    for path, folder in house(root):
        if folder not in SEES_ROS:
            continue
        for match in UNCHECKED_SUBSCRIPTION.finditer(code_of(path.read_text())):
            yield path, 'a subscription that is no checkedSubscription: %s' % ' '.join(match.group(0).split())


def requirements(root):
    """The ids of docs/requirements.md, and whether each is built."""
    text = (root / 'docs/requirements.md').read_text()
    return {name: mark == 'x' for mark, name in re.findall(r'^- \[([ x])\] ([A-Z]{3}-\d+)\b', text, re.MULTILINE)}


def check_requirements(root):
    known = requirements(root)
    cited = set()
    for path in sorted((root / 'test').rglob('*')):
        if path.suffix in ('.cpp', '.h', '.py', '.test') and 'architecture' not in path.parts:
            for name in re.findall(r'\[([A-Z]{3}-\d+)\]', path.read_text()):
                cited.add(name)
                if name not in known:
                    yield path, 'cites [%s], which docs/requirements.md does not have' % name
    for name, built in known.items():
        if built and name not in cited:
            yield root / 'docs/requirements.md', '%s is built, but no test cites [%s]' % (name, name)


CHECKS = (check_arrows, check_purity, check_sizes, check_rooms, check_names, check_subscriptions, check_requirements)


def problems(root):
    for check in CHECKS:
        for path, what in check(root):
            yield '%s: %s' % (path.relative_to(root), what)


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else __file__).resolve()
    root = root if root.is_dir() else root.parents[2]
    found = list(problems(root))
    print('\n'.join(found))
    lengths = sorted(length for path in sources(root, 'include', 'src') for _, length in functions_of(path.read_text()))
    print('%d functions: median %d lines, 90th percentile %d, longest %d; %d problems' % (
        len(lengths), statistics.median(lengths), lengths[len(lengths) * 9 // 10], lengths[-1], len(found)))
    return 1 if found else 0


if __name__ == '__main__':
    sys.exit(main())
