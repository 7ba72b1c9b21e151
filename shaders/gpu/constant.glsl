// For lists of specialisation constants that C++ reads, too: gpu/pipeline/constants.inl.
#define CONSTANT(number, type, name, usual) layout(constant_id = number) const type name = usual;
