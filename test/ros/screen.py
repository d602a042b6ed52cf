"""A screen of its own for a window that a test starts."""
import os
import queue
import socket
import subprocess
import threading

SOCKET = '/tmp/.X11-unix/X'


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


class Network:
    """Between windows and the X server of a screen, as ssh -X is. When it stalls it still takes what is sent, and passes nothing on."""

    def __init__(self, screen):
        self._server = SOCKET + screen.environment['DISPLAY'].lstrip(':')
        display = '1%03d' % int(screen.environment['DISPLAY'].lstrip(':'))
        self._flows = threading.Event()
        self._flows.set()
        self._path = SOCKET + display
        if os.path.exists(self._path):  # left by a test that was killed
            os.unlink(self._path)
        self._listener = socket.socket(socket.AF_UNIX)
        self._listener.bind(self._path)
        self._listener.listen()
        # Without shared memory, Qt draws without waiting for an answer.
        self.environment = dict(screen.environment, DISPLAY=':' + display, QT_XCB_NO_MITSHM='1')
        self._start(self._accept)

    def stall(self):
        self._flows.clear()

    def go_on(self):
        self._flows.set()

    def end(self):
        self._listener.close()
        os.unlink(self._path)
        self._flows.set()

    @staticmethod
    def _start(work, *arguments):
        threading.Thread(target=work, args=arguments, daemon=True).start()

    def _accept(self):
        while True:
            try:
                window, _ = self._listener.accept()
            except OSError:
                return
            server = socket.socket(socket.AF_UNIX)
            server.connect(self._server)
            for source, sink in ((window, server), (server, window)):
                parts = queue.Queue()
                self._start(self._read, source, parts)
                self._start(self._write, parts, sink)

    @staticmethod
    def _read(source, parts):
        part = b'-'
        while part:
            try:
                part = source.recv(65536)
            except OSError:
                part = b''
            parts.put(part)

    def _write(self, parts, sink):
        for part in iter(parts.get, b''):
            self._flows.wait()
            try:
                sink.sendall(part)
            except OSError:
                break
        sink.close()
