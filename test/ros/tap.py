"""A subscriber on a bare socket, which knows what had arrived at the machine at a given moment.

A message that rospy hands over late, from a queue of its own, looks like one that was sent late. Here nothing stands
between the test and the socket: what can be read at once had arrived, and the rest comes afterwards.
"""
import io
import select
import socket
import struct
import time
import xmlrpc.client

import rosgraph
import rosgraph.network


class Tap:
    """The messages of `topic` of `kind` as `publisher` writes them to the wire."""

    def __init__(self, publisher, topic, kind, caller='/tap'):
        self._kind = kind
        self._buffer = b''
        api = rosgraph.Master(caller).lookupNode(publisher)
        code, why, protocol = xmlrpc.client.ServerProxy(api).requestTopic(caller, topic, [['TCPROS']])
        assert code == 1, why
        self._socket = socket.create_connection((protocol[1], protocol[2]))
        self._socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        fields = {'topic': topic, 'md5sum': kind._md5sum, 'type': kind._type, 'callerid': caller, 'tcp_nodelay': '1',
                  'message_definition': kind._full_text}
        self._socket.sendall(rosgraph.network.encode_ros_handshake_header(fields))
        rosgraph.network.read_ros_handshake_header(self._socket, io.BytesIO(), 65536)
        self._socket.setblocking(False)

    def arrived(self):
        """Every message that has arrived by now and was not given before."""
        while True:
            try:
                data = self._socket.recv(65536)
            except BlockingIOError:
                break
            assert data, 'the publisher has closed the connection'
            self._buffer += data
        return self._whole_messages()

    def _whole_messages(self):
        messages = []
        while len(self._buffer) >= 4:
            size = struct.unpack('<I', self._buffer[:4])[0]
            if len(self._buffer) < 4 + size:
                break
            messages.append(self._kind().deserialize(self._buffer[4:4 + size]))
            self._buffer = self._buffer[4 + size:]
        return messages

    def during(self, seconds):
        """Every message that arrives from now on for so long."""
        messages, end = [], time.monotonic() + seconds
        while time.monotonic() < end:
            select.select([self._socket], [], [], max(0.0, end - time.monotonic()))
            messages += self.arrived()
        return messages

    def next(self, count, timeout=10.0):
        """The next messages that arrive, at least so many, which must come in this time."""
        messages, end = [], time.monotonic() + timeout
        while len(messages) < count:
            left = end - time.monotonic()
            assert left > 0.0, 'only %d messages of %d have arrived' % (len(messages), count)
            select.select([self._socket], [], [], left)
            messages += self.arrived()
        return messages

    def until_closed(self, timeout):
        """Every message that arrives before the publisher closes the connection, which it must do in this time."""
        end = time.monotonic() + timeout
        while time.monotonic() < end:
            select.select([self._socket], [], [], max(0.0, end - time.monotonic()))
            try:
                data = self._socket.recv(65536)
            except BlockingIOError:
                continue
            if not data:
                return self._whole_messages()
            self._buffer += data
        raise AssertionError('the publisher has not closed the connection')

    def close(self):
        self._socket.close()
