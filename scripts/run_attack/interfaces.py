"""What the nodes of the system read and serve, as the master and the nodes themselves say."""
import time

import rosgraph
import roslib.message
import rospy
import rosservice

from run_attack.messages import serialised
from run_attack.system import CALLER, NODES

OWN = {'/' + node for node in NODES}


def topics(own=OWN):
    """{topic: message class} of all topics to which one of the nodes `own` is subscribed."""
    master = rosgraph.Master(CALLER)
    subscribers = master.getSystemState()[1]
    types = dict(master.getTopicTypes())
    found = {}
    for topic, nodes in sorted(subscribers):
        kind = roslib.message.get_message_class(types.get(topic, '*')) if types.get(topic, '*') != '*' else None
        if own & set(nodes) and kind is not None:
            found[topic] = kind
    return found


def services():
    """{service: service class} of all services that a node of the system offers."""
    offered = rosgraph.Master(CALLER).getSystemState()[2]
    names = sorted(name for name, nodes in offered if OWN & set(nodes))
    kinds = {name: rosservice.get_service_class_by_name(name) for name in names}
    return {name: kind for name, kind in kinds.items() if kind is not None}


def samples(kinds, seconds, most=20, largest=100000):
    """Records what is published on topics ({topic: class}) for a while: {type: [bytes]}, of messages up to `largest` bytes."""
    found = {}

    def keep(kind):
        def take(message):
            kept = found.setdefault(kind._type, [])
            if len(kept) < most:
                data = serialised(message)
                if len(data) <= largest:
                    kept.append(data)
        return take
    subscribers = [rospy.Subscriber(topic, kind, keep(kind)) for topic, kind in kinds.items()]
    time.sleep(seconds)
    for subscriber in subscribers:
        subscriber.unregister()
    return found
