#include "tools/map_log.h"

int main(int argc, char** argv) { return frontier_pilot::runMapLog({argv + 1, argv + argc}); }
