"""Registers nodes of Python and rosbag again at a new master, which knows nothing of those that the old one had."""
import xmlrpc.client

import rosgraph

from ros_program import FAILURES, PatientTransport, master

ANY = '*'  # the type of a subscription that takes whatever is published


class Registration:
    """What a node of this name publishes and subscribes to, by the master's API. Whoever knows the address of a node may register
    it, so this works for a rosbag of ours as well. Connections that exist are not touched."""

    def __init__(self, name, publications=(), subscriptions=()):
        self.master = master(name)
        self.name = name
        self.publications = list(publications)  # (topic, type)
        self.subscriptions = list(subscriptions)  # topics
        self.uri = None  # of the node, as the last master knew it
        self.complete = True  # whether the last registration reached its end

    def keep(self):
        """Looks whether the master knows the node, and registers it if a new one does not. Returns whether it was registered
        again. To be called now and then; does nothing while there is no master."""
        try:
            self.uri = self.master.lookupNode(self.name)
            if self.complete:
                return False
        except rosgraph.MasterError:
            if self.uri is None:
                return False  # it has not begun yet
        except FAILURES:
            return False
        self.complete = False
        try:
            self._register()
        except FAILURES:
            return False  # the next time
        self.complete = True
        return True

    def _register(self):
        for topic, kind in self.publications:
            self.master.registerPublisher(topic, kind, self.uri)
        node = xmlrpc.client.ServerProxy(self.uri, transport=PatientTransport())
        connected = self._publishers_of(node)
        for topic in self.subscriptions:
            listed = self.master.registerSubscriber(topic, ANY, self.uri)
            # A node drops the publishers that are missing in an update, and a driver that the new master does not know lives on.
            node.publisherUpdate('/master', topic, sorted({*listed, *connected.get(topic, ())}))

    def _publishers_of(self, node):
        """The addresses of those that it is connected to, by topic."""
        uris = {}
        for _, uri, direction, _, topic, *_ in node.getBusInfo(self.name)[2]:
            if direction == 'i':
                uris.setdefault(topic, set()).add(uri)
        return uris
