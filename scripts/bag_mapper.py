"""The mapper that bag_player.py plays a drive to. It may die and be started again meanwhile: the drive waits for it."""
import time

import rospy
from diagnostic_msgs.msg import DiagnosticArray

import ros_program

PATIENCE = 30.0  # for a mapper that ended to be back [s]
LOOK = 0.1  # between two looks whether it is [s]
ANSWER = 3.0  # for its diagnostics, which come each second [s]
TAKEN = ('scans, inserted', 'scans, localised', 'scans, not moved')  # in the diagnostics; all other scans were refused


class BagMapper:
    """The node that offers the map and hears all these publishers. `played` are the player's counts of messages."""

    def __init__(self, played, *publishers):
        self.played = played
        self.publishers = publishers
        self.node, self.address = '', ''  # of the process that listened last
        self.away_since = None  # [s]
        self.next_look = 0.0  # [s]
        self.starts = 0  # how often another process took its place
        self.played_before = 0  # scans, when that happened last

    def find(self):
        """Looks for it at the master, and gives whether it listens."""
        try:
            master = ros_program.master(rospy.get_name())
            node = dict(master.getSystemState()[2])[rospy.resolve_name('dynamic_map')][0]
            address = master.lookupNode(node)
        except (KeyError, IndexError, *ros_program.FAILURES):
            return False
        if not self.hears(node):
            return False
        if self.address and address != self.address:
            self.starts += 1
            self.played_before = self.played['scan']
        self.node, self.address = node, address
        return True

    def hears(self, node):
        return all(publisher.impl.has_connection(node) for publisher in self.publishers)

    def is_away(self):
        """Whether it has ended, or was cut off, and does not listen yet again. One that was never found is never away."""
        if not self.node or self.away_since is None and self.hears(self.node):
            return False
        if rospy.core.is_shutdown_requested():  # which ends all connections
            return False
        now = time.monotonic()
        if self.away_since is None:
            self.away_since = now
            self.disconnect()
            rospy.logwarn('the mapper does not listen any more: the bag waits for it')
        if now >= self.next_look:
            self.next_look = now + LOOK
            if self.find():
                self.away_since = None
                rospy.loginfo('the mapper listens again: the bag goes on')
        return self.away_since is not None

    def disconnect(self):
        """Ends what is left of its connections, so that they do not count as those of the next process: rospy notices only when it writes
        that a reader has died. One that lives connects again."""
        for publisher in self.publishers:
            for connection in list(publisher.impl.connections):
                if connection.endpoint_id == self.node:
                    publisher.impl.remove_connection(connection)

    def is_lost(self):
        """Whether it has been away for so long that nobody will start it again."""
        return self.away_since is not None and time.monotonic() > self.away_since + PATIENCE

    def leave(self):
        """It may end from now on."""
        self.node, self.away_since = '', None

    def taken(self):
        """How many scans the process that listens now has taken; None if it does not say."""
        end = time.monotonic() + ANSWER
        try:
            while time.monotonic() < end:
                for status in rospy.wait_for_message('/diagnostics', DiagnosticArray, ANSWER).status:
                    if status.name == self.node[1:] + ': mapping':
                        return sum(int(each.value) for each in status.values if each.key in TAKEN)
        except rospy.ROSException:
            pass
        return None

    def say_loss(self):
        """What the map lacks because the mapper ended."""
        if not self.starts:
            return
        taken = self.taken()
        rospy.logwarn('the mapper ended %s while the bag was played, and was started again: the map lacks the scans between its last copy '
                      'and its end, about two seconds of real time, and those refused since: of %d scans '
                      'played since it was back it has taken %s',
                      'once' if self.starts == 1 else '%d times' % self.starts, self.played['scan'] - self.played_before,
                      'an unknown number' if taken is None else taken)
