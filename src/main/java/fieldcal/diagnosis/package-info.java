/**
 * What a calibrated model gets wrong, and why.
 *
 * <p>{@link fieldcal.diagnosis.Diagnoser} fits all kicks of a recording together with the simple model, looks for structure in the residuals, tries every known {@link
 * fieldcal.effect.Effect} alone and with others, weighs the explanations by their evidence, and measures on kicks that were held out what the best one gains.
 * The answer is a {@link fieldcal.diagnosis.Diagnosis}: a verdict, the causes with their numbers, what could not be told apart, and what remains unexplained.
 */
package fieldcal.diagnosis;
