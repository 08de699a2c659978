// The program as a portable build has it: the dynamic loader has chosen the library by the instruction set.
extern "C" int unbruised_program(int argc, char** argv);

int main(int argc, char** argv) { return unbruised_program(argc, argv); }
