/**
 * The league's network: UDP packets of vision and referee, received by multicast on one interface or all, with the sources on one group distinguished.
 *
 * <p>{@link fieldcal.app.net.PacketReceiver} receives and never lags: what nobody takes in time is dropped and counted. {@link fieldcal.app.net.VisionSource} and {@link fieldcal.app.net.RefereeSource} decode.
 */
package fieldcal.app.net;
