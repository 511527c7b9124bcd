/**
 * What the {@code diagnose} command does, without the command line: files in, diagnosis, files out.
 *
 * <p>{@link fieldcal.app.diagnose.DiagnosisSession} calibrates as {@code calibrate} does, puts the question to {@link
 * fieldcal.diagnosis.Diagnoser}, and writes the answer; the other classes read and write one kind of file each. {@link
 * fieldcal.app.diagnose.ExtendedModelFile} is used by {@code calibrate --model} too.
 */
package fieldcal.app.diagnose;
