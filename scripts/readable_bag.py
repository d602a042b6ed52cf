"""What can go wrong with a bag before and while rosbag reads it."""
import errno
import os
import struct
import zlib

import genmsg
import genpy
import rosbag

# What rosbag throws for bags that are damaged, or hold a definition of a message that is none.
DAMAGE = (rosbag.ROSBagException, genpy.MessageException, genmsg.MsgGenerationException, genmsg.MsgNotFound,
          genmsg.InvalidMsgSpec, OSError, EOFError, ValueError, KeyError, IndexError, TypeError, AttributeError, struct.error,
          zlib.error, RuntimeError, SyntaxError, MemoryError)

# What the system lacks, of which a bag that is read cannot be the reason: rosbag writes the types of its messages to temporary
# files.
LACKS = (errno.ENOSPC, errno.EDQUOT, errno.EFBIG, errno.EMFILE, errno.ENFILE)


def is_of_the_system(error):
    """Whether what was thrown while a bag was read says nothing about the bag."""
    return isinstance(error, OSError) and error.errno in LACKS


FIRST_LINE = 100  # [bytes], within which the first line of every bag ends


def why_no_bag(path):
    """What is wrong with what must not be opened as a bag: reading a pipe or a device may never end, and rosbag reads the first line of
    any file into memory, which may be gigabytes of zeros after a crash. Empty for all else; rosbag says what is wrong with that."""
    if os.path.exists(path) and not os.path.isfile(path):
        return 'it is not a regular file'
    try:
        with open(path, 'rb') as file:
            beginning = file.read(FIRST_LINE)
    except OSError:
        return ''
    return '' if not beginning or b'\n' in beginning and beginning.startswith(b'#ROS') else 'it does not begin as a bag does'
