#pragma once

namespace frontier_pilot {

/// Waits until the process that has started this one starts no more others for a while, at most 20 s. A roslaunch that
/// loses a required node while it still starts others ends with an exception and leaves some of them behind, with its
/// master: a node that cannot start ends only when the others have been started.
void waitForTheLaunch();

}  // namespace frontier_pilot
