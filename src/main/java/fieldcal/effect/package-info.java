/**
 * Effects that the simple ball model leaves out, and the ball's path with them.
 *
 * <p>An {@link fieldcal.effect.Effect} is an immutable value: one cause with its numbers, absent when its magnitudes are zero. A {@link
 * fieldcal.effect.MotionEffect} changes how the ball moves ({@link fieldcal.effect.ExtendedTrajectory} integrates it), a {@link
 * fieldcal.effect.MeasurementEffect} changes what a camera reports of it ({@link fieldcal.effect.MeasurementEffects} applies it), a {@link
 * fieldcal.effect.KickerEffect} changes what a robot makes of its command. {@link fieldcal.effect.EffectCatalogue} lists all; a new one
 * is one class in {@code effect.motion} or {@code effect.measurement}, one line there and one test. Used by the diagnosis and by programs that predict with
 * an extended model. Everything is immutable but the two working objects {@code BallMotion} and {@code Sight}, which effects only see for the
 * time of a call.
 */
@PublicApi
package fieldcal.effect;

import fieldcal.PublicApi;
