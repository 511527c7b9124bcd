/**
 * How well a fitted model does on kicks that it was not fitted to, and what it leaves: held-out residuals, prediction from the first 0.3 s, and how much of the residuals is not noise.
 */
package fieldcal.diagnosis.validation;
