"""A process that reads `cmd_vel` at a bare socket, as the base does, and keeps when each message has come.

Usage: python3 -m run_attack.probe SECONDS OUT

It hears the arbiter alone, whoever else publishes. No queue of a client library stands between the socket and the clock.
"""
import io
import json
import select
import socket
import struct
import sys
import time
import xmlrpc.client

import rosgraph
import rosgraph.network
from geometry_msgs.msg import Twist

from leftovers import end_with_the_parent

ARBITER, TOPIC, CALLER = '/cmd_vel_arbiter', '/cmd_vel', '/attack_probe'


def connect():
    """A socket to the arbiter as a subscriber of `cmd_vel` without Nagle's delay; OSError where there is none."""
    try:
        address = rosgraph.Master(CALLER).lookupNode(ARBITER)
        code, why, protocol = xmlrpc.client.ServerProxy(address).requestTopic(CALLER, TOPIC, [['TCPROS']])
    except (rosgraph.MasterException, xmlrpc.client.Error) as error:
        raise OSError(str(error))
    if code != 1:
        raise OSError(why)
    wire = socket.create_connection((protocol[1], protocol[2]), 2.0)
    fields = {'topic': TOPIC, 'md5sum': Twist._md5sum, 'type': Twist._type, 'callerid': CALLER, 'tcp_nodelay': '1',
              'message_definition': Twist._full_text}
    wire.sendall(rosgraph.network.encode_ros_handshake_header(fields))
    rosgraph.network.read_ros_handshake_header(wire, io.BytesIO(), 65536)
    wire.setblocking(False)
    return wire


class Stream:
    """Cuts what is read into messages, each with the time at which it had not come yet and that at which it was read."""

    def __init__(self, now):
        self._buffer = b''
        self._empty_at = now

    def found_empty(self, at):
        """The socket had nothing more to read, at the time `at` or later."""
        if not self._buffer:  # else a part of the next message had come before
            self._empty_at = at

    def add(self, data, now):
        """Gives (earliest, latest, moves) of each message that is complete."""
        self._buffer += data
        complete = []
        while len(self._buffer) >= 4:
            size = 4 + struct.unpack_from('<I', self._buffer)[0]
            if len(self._buffer) < size:
                break
            complete.append((self._empty_at, now, any(struct.unpack_from('<6d', self._buffer, 4))))
            self._buffer = self._buffer[size:]
        return complete


def read_until(end, take):
    """Hands all messages of one connection to `take` until the time `end` or the end of the connection."""
    wire, stream = connect(), Stream(time.monotonic())
    try:
        while time.monotonic() < end:
            before = time.monotonic()
            try:
                data = wire.recv(65536)
            except BlockingIOError:
                stream.found_empty(before)
                select.select([wire], [], [], 0.1)
                continue
            if not data:
                return
            take(stream.add(data, time.monotonic()))
    finally:
        wire.close()


def main(seconds, out):
    end_with_the_parent()
    end = time.monotonic() + float(seconds)
    log = {'messages': [], 'connections': 0}

    def take(messages):
        log['messages'] += messages
    while time.monotonic() < end:
        try:
            log['connections'] += 1
            read_until(end, take)
        except OSError:
            time.sleep(0.05)
    with open(out, 'w') as file:
        json.dump(log, file)


if __name__ == '__main__':
    main(*sys.argv[1:])
