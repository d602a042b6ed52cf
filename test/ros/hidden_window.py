#!/usr/bin/env python3
"""The window drops its set-point when a window manager hides it, whichever way it does so."""
import ctypes
import ctypes.util
import shutil
import subprocess
import tempfile
import unittest

import rospy
import rostest
from geometry_msgs.msg import Twist

from screen import Network, Screen
from wire import Record, find_node, moves, wait_for

PRESS, RELEASE = 1, 0
REPLACE, ATOM = 0, 4


@ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_void_p, ctypes.c_void_p)
def ignore_error(_display, _event):
    """A request for a window that has just been unmapped is an error, by which Xlib would end the process."""
    return 0


class Manager:
    """A client of an X server that does to a window what window managers do."""

    def __init__(self, display):
        self.x, self.test = ctypes.CDLL('libX11.so.6'), ctypes.CDLL('libXtst.so.6')
        for function in (self.x.XOpenDisplay, self.x.XDefaultRootWindow, self.x.XCreateSimpleWindow,
                         self.x.XInternAtom, self.x.XStringToKeysym):
            function.restype = ctypes.c_void_p
        self.x.XSetErrorHandler(ignore_error)
        self.display = ctypes.c_void_p(self.x.XOpenDisplay(display.encode()))
        self.root = ctypes.c_void_p(self.x.XDefaultRootWindow(self.display))

    def done(self):
        self.x.XSync(self.display, 0)

    def windows(self):
        """The windows on the screen, the lowest first."""
        root, parent = ctypes.c_ulong(), ctypes.c_ulong()
        children, count = ctypes.POINTER(ctypes.c_ulong)(), ctypes.c_uint()
        self.x.XQueryTree(self.display, self.root, ctypes.byref(root), ctypes.byref(parent), ctypes.byref(children),
                          ctypes.byref(count))
        return [ctypes.c_void_p(children[i]) for i in range(count.value)]

    def width(self, window):
        root, size = ctypes.c_ulong(), [ctypes.c_uint() for _ in range(6)]
        self.x.XGetGeometry(self.display, window, ctypes.byref(root), *[ctypes.byref(value) for value in size])
        return size[2].value

    def frame(self, window):
        """Puts the window into a frame, as most window managers do."""
        frame = ctypes.c_void_p(self.x.XCreateSimpleWindow(self.display, self.root, 0, 0, 900, 700, 0, 0, 0))
        self.x.XReparentWindow(self.display, window, frame, 0, 0)
        self.map(frame)
        return frame

    def map(self, window):
        self.x.XMapWindow(self.display, window)
        self.done()

    def unmap(self, window):
        self.x.XUnmapWindow(self.display, window)
        self.done()

    def atom(self, name):
        return self.x.XInternAtom(self.display, name.encode(), 0)

    def set_states(self, window, *names):
        states = (ctypes.c_ulong * max(1, len(names)))(*[self.atom(name) for name in names])
        self.x.XChangeProperty(self.display, window, ctypes.c_ulong(self.atom('_NET_WM_STATE')), ctypes.c_ulong(ATOM),
                               32, REPLACE, states, len(names))
        self.done()

    def press(self, window, key):
        """Gives the window the focus and presses a key."""
        self.x.XSetInputFocus(self.display, window, 1, ctypes.c_ulong(0))
        self.done()
        code = self.x.XKeysymToKeycode(self.display, ctypes.c_void_p(self.x.XStringToKeysym(key.encode()))) & 0xff
        for direction in (PRESS, RELEASE):
            self.test.XTestFakeKeyEvent(self.display, code, direction, ctypes.c_ulong(0))
        self.done()


class HiddenWindow(unittest.TestCase):
    def setUp(self):
        if shutil.which('Xvfb') is None or ctypes.util.find_library('Xtst') is None:
            self.skipTest('needs Xvfb and libXtst')
        folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, folder)
        self.manual = Record('cmd_vel_manual', Twist)
        self.screen = Screen(folder)
        self.addCleanup(self.screen.end)
        self.manager = Manager(self.screen.environment['DISPLAY'])

    def open_window(self, environment):
        node = subprocess.Popen([find_node('frontier_pilot', 'teleop_gui'), '__name:=window_to_hide'],
                                env=environment, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.addCleanup(node.wait)
        self.addCleanup(node.kill)
        self.assertTrue(wait_for(lambda: len(self.manual.items) > 3, 20.0))
        self.window = max(self.manager.windows(), key=self.manager.width)  # Qt has others that are not seen

    def drive(self):
        def presses():
            self.manager.press(self.window, 'a')
            return wait_for(self.moves, 1.0)
        self.assertTrue(wait_for(presses, 10.0))

    def keeps_driving(self):
        self.drive()
        return not wait_for(lambda: not self.moves(), 1.0)

    def moves(self):
        return moves(self.manual.last)

    def assert_stands(self, how):
        self.assertTrue(wait_for(lambda: not self.moves(), 2.0), how)
        self.assertFalse(wait_for(self.moves, 0.5), how)

    def test_a_window_that_a_window_manager_hides_does_not_drive_on(self):
        """[GUI-1]"""
        self.open_window(self.screen.environment)
        frame = self.manager.frame(self.window)
        # A window that a busy machine holds up for longer than its set-point lives drops it as well.
        self.assertTrue(any(self.keeps_driving() for _ in range(3)), 'it drives while it is seen')
        self.manager.unmap(frame)
        self.assert_stands('its frame is unmapped: another workspace, or behind a tab')
        self.manager.map(frame)
        self.drive()
        self.manager.set_states(self.window, '_NET_WM_STATE_HIDDEN')
        self.assert_stands('it is marked as hidden, and stays mapped for a preview')
        self.manager.set_states(self.window)
        self.drive()
        self.manager.unmap(self.window)
        self.assert_stands('it is unmapped itself')

    def test_a_window_whose_display_stalls_does_not_drive_on(self):
        """[GUI-4] It does not hear of a key that is let go."""
        network = Network(self.screen)
        self.addCleanup(network.end)
        self.open_window(network.environment)
        self.drive()
        network.stall()
        self.assert_stands('the X server does not answer')
        network.go_on()
        self.drive()


if __name__ == '__main__':
    rospy.init_node('hidden_window', disable_rostime=True)
    rostest.rosrun('frontier_pilot', 'hidden_window', HiddenWindow)
