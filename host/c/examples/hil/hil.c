/* A target for `schuler hil` on a desktop: it serves one host on a TCP port of this machine.
 *
 *     hil 5000 &
 *     schuler hil paper --device tcp:127.0.0.1:5000 */

#define _POSIX_C_SOURCE 200809L

#include "schuler.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <unistd.h>

static void send_all(void *context, const uint8_t *bytes, size_t count)
{
    const int *line = context;

    while (count > 0U) {
        ssize_t sent = write(*line, bytes, count);

        if (sent <= 0) {
            return;
        }
        bytes += sent;
        count -= (size_t)sent;
    }
}

int main(int argc, char **argv)
{
    static schuler_target target;
    struct sockaddr_in address;
    socklen_t length = sizeof address;
    int listener = socket(AF_INET, SOCK_STREAM, 0);
    int line;
    int yes = 1;
    int32_t status;

    (void)memset(&address, 0, sizeof address);
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    address.sin_port = htons((uint16_t)((argc > 1) ? atoi(argv[1]) : 0));
    if ((listener < 0) || (bind(listener, (const struct sockaddr *)&address, sizeof address) != 0)
        || (listen(listener, 1) != 0) || (getsockname(listener, (struct sockaddr *)&address, &length) != 0)) {
        perror("hil");
        return 1;
    }
    /* With port 0 the system has chosen one. */
    (void)printf("tcp:127.0.0.1:%u\n", (unsigned)ntohs(address.sin_port));
    (void)fflush(stdout);
    line = accept(listener, NULL, NULL);
    if (line < 0) {
        perror("hil");
        return 1;
    }
    (void)setsockopt(line, IPPROTO_TCP, TCP_NODELAY, &yes, sizeof yes);
    status = schuler_target_start(&target, SCHULER_ABI, 0U);
    if (status == SCHULER_OK) {
        status = schuler_target_hello(&target, send_all, &line);
    }
    while (status == SCHULER_OK) {
        uint8_t bytes[4096];
        ssize_t count = read(line, bytes, sizeof bytes);
        ssize_t i;

        if (count <= 0) {
            break;
        }
        for (i = 0; (i < count) && (status == SCHULER_OK); i++) {
            status = schuler_target_take(&target, bytes[i], send_all, &line);
        }
    }
    if (status != SCHULER_OK) {
        (void)fprintf(stderr, "hil: %s\n", schuler_result_text(status));
    }
    (void)close(line);
    (void)close(listener);
    return (status == SCHULER_OK) ? 0 : 1;
}
