/**
 * A field with ball, robots and cameras whose truth is known: recordings for tests, for hidden-effect studies and for dry runs without hardware.
 *
 * <p>{@link fieldcal.simulation.Simulation} runs a {@link fieldcal.simulation.scenario.Scenario} under {@link fieldcal.simulation.SimulationSettings} and answers what vision sent and what
 * really happened. {@link fieldcal.simulation.SimulatedEffect} lists what can be wrong with such a field; {@link fieldcal.simulation.SimulatedWorld} is the field itself, for whoever wants to
 * drive the robots. The physics is integrated and shares nothing with the models that fieldcal fits (package {@code physics}).
 *
 * <p>The same settings give the same recording, byte by byte.
 */
package fieldcal.simulation;
