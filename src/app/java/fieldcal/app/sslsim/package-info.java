/**
 * The league's simulation protocol over UDP, both sides: {@link fieldcal.app.sslsim.NetworkPlayField} drives any simulator that speaks it, {@link fieldcal.app.sslsim.SimulatorServer} serves our own
 * field with it.
 */
package fieldcal.app.sslsim;
