/**
 * What the simple model gets wrong, why, and what a better one gains: {@link fieldcal.diagnosis.Diagnoser} composes the stages that live in the packages below (screening, search, decision, validation) into an immutable {@link
 * fieldcal.diagnosis.Diagnosis}. Knows effects by their interface alone. Used by the command line, the console and the play.
 */
package fieldcal.diagnosis;
