"""Has the mapper save its map: under a name that no map has yet, and elsewhere where that cannot be written."""
import datetime
import enum
import os
import queue
import sys
import threading

import rospkg
import rospy
from frontier_pilot.srv import SaveMap

from command_line import say
from run_recording import free_name

DISK = 10.0  # [s], for which a disk is waited for that may only have to wake up
MAPPER = 35.0  # [s], a little longer than the mapper waits for a disk, and before that for its map
RESTART = 30.0  # [s], for which a mapper is waited for that died and is started again


def default_prefix(folder='maps'):
    """The path of a map in this folder that is this run's alone, also if another one ends in the same second: its picture is
    there, and empty, until the map is saved. OSError if it cannot be made."""
    os.makedirs(folder, exist_ok=True)
    return taken(name_of_now(folder))


def name_of_now(folder):
    return os.path.abspath(os.path.join(folder, datetime.datetime.now().strftime('%Y-%m-%d_%H-%M-%S')))


def taken(name):
    """This path of a map, or one with a number behind it, with an empty picture that nobody else has made."""
    return free_name.take(name, lambda path: os.close(os.open(path + '.pgm', os.O_CREAT | os.O_EXCL | os.O_WRONLY, 0o666)))


class NotSaved(Exception):
    """Why the mapper has not written a map."""


class NoAnswer(Exception):
    """What does not answer, a disk or the mapper."""


class Saved(enum.Enum):
    """Where a map was saved."""
    WHERE_ASKED = 1
    ELSEWHERE = 2  # in the spare folder, because it could not be written where it was to be
    NOWHERE = 3


def save_map(prefix, beside=False):
    """Has the mapper save the map, `beside` one of that name if there is one, and prints where it is, or why it is not: if that fails
    it is asked once more, as it may just have been started again, and then for another folder, because the map is lost when it ends. If
    this computer's disk or the mapper does not answer at all, the other folder is next."""
    spare = os.path.abspath(os.path.join(rospkg.get_ros_home(), 'frontier_pilot', 'maps'))
    def wanted():
        return (free_prefix(prefix) if prefix and beside else prefix) or default_prefix()
    elsewhere = '; another folder is tried, %s' % spare
    attempts = [(wanted, Saved.WHERE_ASKED, '; it is tried once more'), (wanted, Saved.WHERE_ASKED, elsewhere),
                (lambda: default_prefix(spare), Saved.ELSEWHERE, '')]
    while attempts:
        path_of, where, outlook = attempts.pop(0)
        try:
            path = ask_to_save(path_of, '' if attempts else name_of_now(spare))
            if where is Saved.ELSEWHERE:
                say('The argument map_file:=%s.yaml begins with it' % path)
            return where
        except NoAnswer as error:
            del attempts[:-1]
            say('The map could not be saved: %s%s' % (error, elsewhere if attempts else ''), sys.stderr)
        except (OSError, NotSaved, rospy.ServiceException) as error:
            say('The map could not be saved: %s%s' % (error, outlook), sys.stderr)
        except rospy.ROSException as error:  # there is no mapper that could be asked again
            say('The map could not be saved: %s' % error, sys.stderr)
            return Saved.NOWHERE
    return Saved.NOWHERE


def within(patience, what, do, *arguments):
    """What `do` gives or raises; NoAnswer, which names `what` does not answer, if it takes longer than `patience` [s]. It goes on then on
    a thread that does not hold up the end of this program."""
    ended = queue.Queue()

    def run():
        try:
            ended.put((do(*arguments), None))
        except Exception as error:
            ended.put((None, error))
    threading.Thread(target=run, daemon=True).start()
    try:
        result, error = ended.get(timeout=patience)
    except queue.Empty:
        raise NoAnswer('%s has not answered for %.0f s' % (what, patience)) from None
    if error:
        raise error
    return result


def ask_to_save(path_of, otherwise):
    """Has the mapper save the map to the path that this gives, prints where it is, and gives the path. Raises what went wrong. If nothing
    can be prepared there it is asked all the same for a path `otherwise`, if given: a mapper that was asked in vain leaves its copy."""
    try:
        path = within(DISK, 'the disk on which it was to be', once_the_disk_answers, path_of)
    except (OSError, NoAnswer):
        if not otherwise:
            raise
        path = otherwise
    try:
        rospy.wait_for_service('mapper/save_map', timeout=RESTART)
        answer = within(MAPPER, 'the mapper', rospy.ServiceProxy('mapper/save_map', SaveMap), path)
        if not answer.success:
            raise NotSaved(answer.message)
    except Exception:
        was_left_empty(path)
        raise
    # The mapper leaves an extension such as .yaml out of the names. It has written elsewhere what was made here and is still empty.
    say('Map saved: %s%s' % (answer.message.removeprefix('saved '), ', on the computer of the mapper' if was_left_empty(path) else ''))
    return path


def was_left_empty(path):
    """Whether the picture of this map was made to take its name and is still empty; removes it then."""
    try:
        return within(DISK, 'the disk', remove_empty, path + '.pgm')
    except NoAnswer:
        return False


def once_the_disk_answers(path_of):
    """The whole path that this gives. Its folder may be on the computer of the mapper only."""
    path = os.path.abspath(path_of())
    os.path.isdir(os.path.dirname(path))
    return path


def remove_empty(path):
    """Removes a picture that was made to take its name; returns whether there was one."""
    try:
        if os.path.getsize(path) == 0:
            os.remove(path)
            return True
    except OSError:
        pass  # there is none, or its disk is gone
    return False


def free_prefix(prefix):
    """This path of a map without what the mapper leaves out of it, or one with a number behind it if there is such a map; empty if
    neither can be made."""
    name, extension = os.path.splitext(os.path.abspath(prefix))
    try:
        return taken(name if extension in ('.pgm', '.yaml', '.bt') else name + extension)
    except OSError:
        return ''
