#pragma once

#include <diagnostic_updater/DiagnosticStatusWrapper.h>
#include <frontier_pilot/AvoiderStatus.h>

#include <string>

#include "frontier_pilot/avoid/avoider.h"

namespace frontier_pilot {

/// State and reason.
std::string summarize(const avoid::AvoiderSnapshot& snapshot);

/// The status for the wire, in words; distances are NaN while they are not known.
AvoiderStatus toStatusMsg(const avoid::AvoiderSnapshot& snapshot);

/// The same at a glance, for /diagnostics.
void fillDiagnostics(const avoid::AvoiderSnapshot& snapshot, diagnostic_updater::DiagnosticStatusWrapper& diagnostics);

}  // namespace frontier_pilot
