/* The digests on a microcontroller. */

int fly_all(void);
int main(void);

int main(void)
{
    return fly_all();
}
