/**
 * From many kicks to one ball model.
 *
 * <p>{@link fieldcal.calibration.Calibrator} estimates what each camera adds to its positions, fits every kick, flat ones first,
 * selects samples per parameter (two sigma, repeated; and by hand), averages what remains and fits all kicks jointly beside it.
 * {@link fieldcal.calibration.Calibration} holds all of it: nothing is thrown away, what was not used says why.
 *
 * <p>{@link fieldcal.calibration.ExtendedCalibrator} does the same under a model with {@link fieldcal.effect effects}.
 *
 * <p>Used by the operator tools and by {@code verdict}.
 */
@PublicApi
package fieldcal.calibration;

import fieldcal.PublicApi;
