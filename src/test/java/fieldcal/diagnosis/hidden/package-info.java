/**
 * Hidden-effect tests: a field, its cameras and what is wrong with it are drawn from a seed, simulated, and diagnosed without the truth.
 *
 * <p>{@link fieldcal.diagnosis.hidden.HiddenCase} is what was drawn, {@link fieldcal.diagnosis.hidden.HiddenRun} what the code under test makes of it, {@link
 * fieldcal.diagnosis.hidden.Visibility} how much there was to see, and {@link fieldcal.diagnosis.hidden.Judgement} compares the two. A few cases run with the tests,
 * hundreds with {@code ./gradlew hiddenEffectStudy}.
 */
package fieldcal.diagnosis.hidden;
