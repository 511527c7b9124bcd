/**
 * Smooth terms that describe what no named effect explains: effects like any other, whose parameters are the coefficients of a basis.
 *
 * <p>A {@link fieldcal.effect.learned.LearnedFamily} says what a term changes ({@link fieldcal.effect.learned.Quantity}), on what it depends ({@link
 * fieldcal.effect.learned.Variable}) and in which {@link fieldcal.effect.learned.Basis}; a {@link fieldcal.effect.learned.LearnedTerm} is a family with
 * coefficients. {@link fieldcal.effect.learned.LearnedLibrary} lists the families that a recording can be searched for. A {@link
 * fieldcal.effect.learned.LearnedCurve} is what was found, with bounds, and {@link fieldcal.effect.learned.SimpleFormula} says it in few
 * numbers. Used by the diagnosis and by programs that predict with an extended model.
 */
@PublicApi
package fieldcal.effect.learned;

import fieldcal.PublicApi;
