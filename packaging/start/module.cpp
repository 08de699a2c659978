// Python's module as a portable build has it: PyInit__unbruised is found in the library it is linked with, which the dynamic
// loader has chosen by the instruction set.
