#pragma once

namespace frontier_pilot {

/// Replaces two methods of this node's slave API (XML-RPC), with which one request ends a node of roscpp: a
/// `system.multicall` that calls itself exhausts the stack, and a `requestTopic` for UDPROS with datagrams of 8 bytes
/// divides by zero. Afterwards `system.multicall` is refused, and `requestTopic` offers TCPROS only, as that of rospy
/// does. To be called after ROS was started. [FLT-1]
void replaceHarmfulMethods();

}  // namespace frontier_pilot
