/**
 * The command line: one class per command, each of which reads its arguments, calls the library and prints.
 *
 * <p>{@link fieldcal.app.cli.Main} holds what all commands share: exit codes (0 success, 1 bad input, 2 bad usage) and one
 * clear line instead of a stack trace. Progress goes to the error stream, and only if that is a terminal.
 */
package fieldcal.app.cli;
