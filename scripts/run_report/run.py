"""What happened in a run, from the messages of its bags."""
import json
import math
import statistics

from .goals import Goals
from .intervals import States, merged
from .load import Load, is_time
from .parameters import inside
from .plausible import check, is_nested_too_deep
from .progress import Counts, progress_of
from .track import MapImage, Track, bare
from .warnings import Warnings

EMERGENCY_STOP = 2  # ArbiterStatus
SILENCE = 30.0  # [s] without any message, of which several come each second, after which something has happened to the clock
LIFETIME = 5.0  # [s], in which the arbiter and the avoider say several times what they do
AVOIDING = (3, 4, 5, 6)  # AvoiderStatus: reverse, rotate, fault, stuck
# What a bag is read for, by the names that our nodes give to the topics, with their types.
ROLES = {'map': 'nav_msgs/OccupancyGrid', 'map_updates': 'map_msgs/OccupancyGridUpdate', '/tf': 'tf2_msgs/TFMessage',
         '/tf_static': 'tf2_msgs/TFMessage', 'cmd_vel_arbiter/status': 'frontier_pilot/ArbiterStatus',
         'obstacle_avoider/status': 'frontier_pilot/AvoiderStatus', 'navigator/status': 'std_msgs/String',
         'frontier_explorer/status': 'frontier_pilot/ExplorerStatus', 'frontier_explorer/goal': 'geometry_msgs/PoseStamped',
         'simulator/stalled': 'std_msgs/Bool', 'run_recorder/load': 'frontier_pilot/ProcessLoads',
         '/diagnostics': 'diagnostic_msgs/DiagnosticArray', '/rosout': 'rosgraph_msgs/Log',
         'turtlebot3/result': 'frontier_pilot/PatrolActionResult', 'spin/result': 'frontier_pilot/SpinActionResult',
         'back_up/result': 'frontier_pilot/BackUpActionResult', 'drive_on_heading/result': 'frontier_pilot/DriveOnHeadingActionResult'}
TYPES = dict(ROLES, odom='nav_msgs/Odometry')


def read_info(text):
    """What the recorder has noted; None if it is not of the recorder's form, because somebody else can publish there too."""
    try:
        info = json.loads(text)
    except (ValueError, TypeError, RecursionError):
        return None
    forms = {'moment': str, 'wall_time': (int, float), 'namespace': str, 'topics': dict, 'parameters': dict}
    if not isinstance(info, dict) or not all(isinstance(info.get(key), form) for key, form in forms.items()):
        return None
    is_good = is_time(info['wall_time']) and all(isinstance(topic, str) for topic in info['topics'].values()) and \
        not is_nested_too_deep(info)
    return info if is_good else None


def names_in(bags, infos):
    """The topic of each role: as the recorder has noted, or else by the end of its name."""
    topics = bags.topics()
    noted = infos[0]['topics'] if infos else {}
    names = {}
    for role, kind in TYPES.items():
        alike = [name for name in topics if topics[name] == kind and ('/' + name.lstrip('/')).endswith('/' + role.lstrip('/'))]
        if role in noted:  # without a message in the bag nothing is known of it: another robot may have such a topic
            if topics.get(noted[role]) == kind:
                names[role] = noted[role]
        elif alike:
            names[role] = min(alike, key=len)
    return names


class Run:
    """Everything that a report shows. Times are ROS times [s], poses are in the frame of the map [m, rad]."""

    def __init__(self):
        self.notes = []  # about the record itself
        self.begin = self.end = 0.0
        self.start_info, self.end_info = None, None  # of the recorder
        self.real_seconds = None  # how long it took in real time, if that is known
        self.map, self.track = MapImage(), Track()
        self.goals, self.load, self.warnings = Goals(), Load(), Warnings()
        self.explorer = []  # (time, Progress)
        self.counts = Counts()
        self.frontiers = []  # (x, y) of the last status [m]
        self.source, self.avoiding = States(LIFETIME), States(LIFETIME)
        self.stop, self.contact, self.recovery = States(), States(), States()
        self.actions = []  # (time, action, text of the result)
        self.heard = set()  # the roles of which there was a message that could be used
        self.takes = {
            'map': self._map, 'map_updates': lambda _, update: self.map.change(update),
            '/tf': self._tf, '/tf_static': self._tf, 'cmd_vel_arbiter/status': self._arbiter,
            'obstacle_avoider/status': self._avoider, 'navigator/status': self._navigator,
            'frontier_explorer/status': self._explorer, 'frontier_explorer/goal': self.goals.take_pose,
            'simulator/stalled': self._stalled, 'run_recorder/load': self.load.take,
            '/diagnostics': self.warnings.take_diagnostics, '/rosout': self.warnings.take_log}

    def read(self, bags):
        """Takes all messages of `bags`, a BagFiles."""
        infos = self._read_info(bags)
        names = names_in(bags, infos)
        self.begin, self.end = bags.span()
        self._find_frames(bags, names)
        self.warnings.namespace = self.start_info and self.start_info['namespace']
        roles = {name: role for role, name in names.items() if role in ROLES}
        last, gaps = self.begin, []
        for topic, message, time in bags.messages(list(roles)):
            if time - last > LIFETIME and bags.has_a_break(last, time):
                for states in (self.source, self.avoiding, self.contact, self.recovery):
                    states.interrupt(last)
            elif self.start_info and time - last > SILENCE:
                gaps.append(time - last)
            last = time
            self.begin, self.end = min(self.begin, time), max(self.end, time)
            try:
                self._take(roles[topic], time, message)
                self.heard.add(roles[topic])
            except (AttributeError, TypeError, ValueError) as error:  # as of another version of the package
                note = '%s has messages that are not understood: %s' % (topic, error)
                if note not in self.notes:
                    self.notes.append(note)
        self.goals.place_all()
        self._note_clocks(gaps, self._measure_real_time(bags))
        self.notes += bags.notes
        if not self.begins_with_the_start():
            self.notes.append('The record does not go back to the start of the run: %s. The figures of the explorer count from its '
                              'start.' % ('the recorder was started later' if bags.has_the_first_part()
                                          else 'its oldest part was removed to keep within the size allowed'))

    def _measure_real_time(self, bags):
        """Without the jumps of a computer's clock that was set meanwhile; gives whether there were any."""
        samples = sorted(self.load.wall, key=lambda sample: sample[2])
        if self.end_info:
            samples.append((self.end, self.end_info['wall_time'], math.inf))
        # A record may begin later than its recorder: when its oldest part was removed, the disk was full, or there was no clock yet.
        if self.start_info and not (self.load.wall and samples[0][1] - self.start_info['wall_time'] > SILENCE):
            samples.insert(0, (self.begin, self.start_info['wall_time'], -1))
        steps = [(after - before, bags.has_a_break(since, until))
                 for (since, before, _), (until, after, _) in zip(samples, samples[1:])]
        if not steps:
            return False
        most = max(SILENCE, 3.0 * statistics.median(step for step, _ in steps))
        regular = [0.0 <= step and (step <= most or is_break) for step, is_break in steps]
        self.real_seconds = sum(step for (step, _), counts in zip(steps, regular) if counts)
        return not all(regular)

    def _note_clocks(self, gaps, computer_jumped):
        """`gaps` are the times without a message [s]."""
        if self.load.was_set_back():
            self.notes.append('The clock was set back while this was recorded, or the simulator was started again: what came after it '
                              'lies over what came before, and durations are wrong.')
        elif gaps:
            self.notes += ['Nothing was recorded for %.0f s: the clock was set forward, or the computer was asleep. Durations over '
                           'this time are too long.' % gap for gap in gaps]
        elif computer_jumped:
            self.notes.append("The computer's clock was set while this was recorded, or it was asleep: the real time is without that.")

    def _take(self, role, time, message):
        check(message)
        if role.endswith('/result'):
            self._action(role[:-len('/result')], time, message)
        else:
            self.takes[role](time, message)

    def begins_with_the_start(self):
        """Whether nothing was explored before the first message."""
        return not self.explorer or self.explorer[0][1].goals_sent <= 1

    def _read_info(self, bags):
        topics = [name for name, kind in bags.topics().items() if name.endswith('run_recorder/info') and kind == 'std_msgs/String']
        infos = [info for info in (read_info(getattr(message, 'data', None)) for _, message, _ in bags.messages(topics)) if info]
        starts, ends = ([info for info in infos if info.get('moment') == word] for word in ('start', 'end'))
        self.start_info, self.end_info = starts[0] if starts else None, ends[-1] if ends else None
        return starts + ends

    def _find_frames(self, bags, names):
        """The frame of the map, from the first message that names it, and those that may be the robot's: the one that its odometry
        names, if it names any, and the one of the parameters."""
        robot = inside((self.start_info or {}).get('parameters', {}), self.namespace() + '/navigator/robot')
        if 'base_frame' in robot:
            self.track.base_frames = [bare(str(robot['base_frame']))]
        for role, take in (('map', lambda m: setattr(self.track, 'map_frame', bare(m.header.frame_id))),
                           ('odom', lambda m: self.track.base_frames.insert(0, bare(m.child_frame_id)))):
            if role in names:
                for _, message, _ in bags.messages([names[role]]):
                    try:
                        take(message)
                    except (AttributeError, TypeError):  # damaged: of another type
                        continue
                    break

    def namespace(self):
        """The namespace of the robot that was recorded."""
        return (self.start_info or {}).get('namespace', '/')

    def _map(self, _, grid):
        self.map.take(grid)

    def _tf(self, time, message):
        self.track.add(time, message.transforms)

    def _arbiter(self, time, status):
        self.source.add(time, status.active_source)
        self.stop.add(time, status.emergency_stop_cause or 'stopped' if status.state == EMERGENCY_STOP else '')

    def _avoider(self, time, status):
        self.avoiding.add(time, status.summary if status.state in AVOIDING else '')

    def _navigator(self, time, text):
        self.recovery.add(time, text.data if text.data.startswith('recovering') else '')

    def _explorer(self, time, status):
        progress = progress_of(status)
        self.frontiers = [(frontier.centroid.x, frontier.centroid.y) for frontier in status.frontiers]
        self.goals.take_status(time, progress)
        self.explorer.append((time, progress))
        self.counts.take(progress)

    def _stalled(self, time, message):
        self.contact.add(time, bool(message.data))

    def _action(self, action, time, message):
        result = message.result
        text = getattr(result, 'result', None) or getattr(result, 'error_msg', '') or message.status.text or 'done'
        self.actions.append((time, 'patrol' if action == 'turtlebot3' else action, text))  # the patrol server's action

    def status(self):
        """The Progress of the explorer's last status, with counts of the whole run; None if there is none. After the clock was set back
        statuses of before and after that lie between each other, and the counts are those of the last one."""
        if not self.explorer:
            return None
        last = self.explorer[-1][1]
        return last if self.load.was_set_back() else last._replace(**self.counts.whole())

    def recoveries(self):
        """The spans (begin, end) in which the navigation recovered."""
        return merged(self.recovery.those(self.end))
