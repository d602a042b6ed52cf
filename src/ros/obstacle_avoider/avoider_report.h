#pragma once

#include <diagnostic_updater/DiagnosticStatusWrapper.h>
#include <frontier_pilot/AvoiderStatus.h>

#include <string>

#include "frontier_pilot/avoid/avoider.h"

namespace frontier_pilot {

/// State and reason in one line.
std::string summarize(const avoid::AvoiderSnapshot& snapshot);

/// The status message; distances are NaN while they are not known.
AvoiderStatus toStatusMsg(const avoid::AvoiderSnapshot& snapshot);

/// The most important of it, for /diagnostics.
void fillDiagnostics(const avoid::AvoiderSnapshot& snapshot, diagnostic_updater::DiagnosticStatusWrapper& diagnostics);

}  // namespace frontier_pilot
