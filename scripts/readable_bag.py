"""What can go wrong with a bag before and while rosbag reads it."""
import os
import struct
import zlib

import genmsg
import genpy
import rosbag

# What rosbag throws for bags that are damaged.
DAMAGE = (rosbag.ROSBagException, genpy.MessageException, genmsg.MsgGenerationException, genmsg.MsgNotFound,
          genmsg.InvalidMsgSpec, OSError, EOFError, ValueError, KeyError, IndexError, TypeError, AttributeError, struct.error,
          zlib.error, RuntimeError)


def is_no_file(path):
    """Whether `path` is something that must not be opened as a bag: reading a pipe or a device may never end."""
    return os.path.exists(path) and not os.path.isfile(path)
