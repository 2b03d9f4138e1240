// The program: reads the call, runs the verb, and turns whatever happens into an exit code.
#include <cli/program.h>

int main(int argc, char** argv) { return sunder::cli::run(argc, argv); }
