"""A screen of its own for a window that a test starts."""
import os
import subprocess


class Screen:
    """An X server without a monitor, with a folder for what its windows write. Ends with end()."""

    def __init__(self, folder):
        read_end, write_end = os.pipe()
        self._server = subprocess.Popen(
            ['Xvfb', '-displayfd', str(write_end), '-screen', '0', '1024x768x24', '+extension', 'GLX'],
            pass_fds=[write_end], stderr=subprocess.DEVNULL)
        os.close(write_end)
        with os.fdopen(read_end) as display:
            number = display.readline().strip()
        self.environment = dict(os.environ, DISPLAY=':' + number, LIBGL_ALWAYS_SOFTWARE='1', XDG_RUNTIME_DIR=folder)
        self.environment.pop('QT_QPA_PLATFORM', None)

    def end(self):
        if self._server.poll() is None:
            self._server.kill()
        self._server.wait()
