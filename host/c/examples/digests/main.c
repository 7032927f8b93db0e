/* The digests on a desktop. */

#include <stdio.h>

void say(const char *text);
int fly_all(void);

void say(const char *text)
{
    (void)fputs(text, stdout);
}

int main(void)
{
    return fly_all();
}
