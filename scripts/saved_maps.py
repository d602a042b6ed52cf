"""Has the mapper save its map: under a name that no map has yet, and elsewhere where that cannot be written."""
import datetime
import enum
import os
import sys

import rospkg
import rospy
from frontier_pilot.srv import SaveMap

from command_line import say
from run_recording import free_name


def default_prefix(folder='maps'):
    """The path of a map in this folder that is this run's alone, also if another one ends in the same second: its picture is
    there, and empty, until the map is saved. OSError if it cannot be made."""
    os.makedirs(folder, exist_ok=True)
    return taken(os.path.abspath(os.path.join(folder, datetime.datetime.now().strftime('%Y-%m-%d_%H-%M-%S'))))


def taken(name):
    """This path of a map, or one with a number behind it, with an empty picture that nobody else has made."""
    return free_name.take(name, lambda path: os.close(os.open(path + '.pgm', os.O_CREAT | os.O_EXCL | os.O_WRONLY, 0o666)))


class NotSaved(Exception):
    """Why the mapper has not written a map."""


class Saved(enum.Enum):
    """Where a map was saved."""
    WHERE_ASKED = 1
    ELSEWHERE = 2  # in the spare folder, because it could not be written where it was to be
    NOWHERE = 3


def save_map(prefix):
    """Has the mapper save the map, and prints where it is, or why it is not: if that fails it is asked once more, as it may just have
    been started again, and then for another folder, because the map is lost when it ends."""
    spare = os.path.abspath(os.path.join(rospkg.get_ros_home(), 'frontier_pilot', 'maps'))
    def wanted():
        return prefix or default_prefix()
    for path_of, where, outlook in ((wanted, Saved.WHERE_ASKED, '; it is tried once more'),
                                    (wanted, Saved.WHERE_ASKED, '; another folder is tried, %s' % spare),
                                    (lambda: default_prefix(spare), Saved.ELSEWHERE, '')):
        try:
            ask_to_save(path_of)
            return where
        except (OSError, NotSaved, rospy.ServiceException) as error:
            say('The map could not be saved: %s%s' % (error, outlook), sys.stderr)
        except rospy.ROSException as error:  # there is no mapper that could be asked again
            say('The map could not be saved: %s' % error, sys.stderr)
            return Saved.NOWHERE
    return Saved.NOWHERE


def ask_to_save(path_of):
    """Has the mapper save the map to the path that this gives, and prints where it is. Raises what went wrong."""
    path = os.path.abspath(path_of())
    try:
        rospy.wait_for_service('mapper/save_map', timeout=10.0)
        answer = rospy.ServiceProxy('mapper/save_map', SaveMap)(path)
        if not answer.success:
            raise NotSaved(answer.message)
    except Exception:
        remove_empty(path + '.pgm')
        raise
    # The mapper leaves an extension such as .yaml out of the names. It has written elsewhere what was made here and is still empty.
    say('Map saved: %s%s' % (answer.message.removeprefix('saved '),
                             ', on the computer of the mapper' if remove_empty(path + '.pgm') else ''))


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
