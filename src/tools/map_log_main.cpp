#include "tools/map_log.h"

int main(int argc, char** argv) { return frontier_pilot::tools::runMapLog({argv + 1, argv + argc}); }
