/**
 * The operator's console: a web server with one page, on which kicks are looked at, dropped and restored, the model is diagnosed and published. {@link
 * fieldcal.app.console.Console} starts it for one session, a directory with recordings and results.
 *
 * <p>The server keeps the state ({@code KickDesk}, {@code DiagnosisDesk}) and does long work one at a time ({@code Work}); the page asks for it and is told of changes by
 * server-sent events ({@code EventHub}), so that all windows show the same. What may be asked, and by whom, is decided in one place ({@code RequestGuard}).
 */
package fieldcal.app.console;
