#pragma once

namespace frontier_pilot {

/// Replaces three methods of this node's slave API (XML-RPC), with which one request ends a node of roscpp: a
/// `system.multicall` that calls itself exhausts the stack, and a `requestTopic` for UDPROS with datagrams of 8 bytes
/// divides by zero. Afterwards `system.multicall` is refused, and `requestTopic` offers TCPROS only, as that of rospy
/// does. `shutdown` is replaced as well, by one that keeps the reason for `isReplaced`, and that refuses what the
/// master says to a process that was killed and whose port is this node's now. To be called after ROS was started.
/// [FLT-1]
void replaceHarmfulMethods();

/// Whether the master has shut this node down because another process registered under its name, be it that this one
/// has ended since. [FLT-2]
bool isReplaced();

}  // namespace frontier_pilot
