# CMake asks for a file of the system's name; it has nothing to say.
