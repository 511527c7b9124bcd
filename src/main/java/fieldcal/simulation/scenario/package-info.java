/**
 * What the robots of the simulated field do: collect flat and chip kicks, or play a match.
 *
 * <p>A {@link fieldcal.simulation.scenario.Scenario} is given the world before each tick and commands the robots, as a team's AI would.
 */
package fieldcal.simulation.scenario;
