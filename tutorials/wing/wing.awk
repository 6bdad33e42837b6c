#-----------------------------------------------------------------------------
# Half of a wing, as an OBJ surface: NACA 0012 with a sharp trailing edge, a chord
# of 1 at the symmetry plane z = 0, where it is open, and of 0.6 at the tip, z = 2,
# which is flat. The quarter-chord line is swept by 15 degrees.
#-----------------------------------------------------------------------------
function thickness(x)
{
    return 0.6*(0.2969*sqrt(x) - 0.1260*x - 0.3516*x^2 + 0.2843*x^3 - 0.1036*x^4)
}

# Point i of 0..2n - 1 of section j: from the trailing edge over the upper side
# to the leading edge, and back
function label(i, j)
{
    return 1 + 2*n*j + i % (2*n)
}

BEGIN {
    pi = atan2(0, -1)
    n = 60
    m = 40

    for (j = 0; j <= m; ++j)
    {
        z = 2*j/m
        chord = 1 - 0.2*z
        front = z*sin(pi/12)/cos(pi/12) - 0.25*chord

        for (i = 0; i < 2*n; ++i)
        {
            x = 0.5*(1 + cos(pi*i/n))
            y = thickness(x)
            printf "v %.9g %.9g %.9g\n",
                front + chord*x, chord*(i < n ? y : -y), z
        }
    }

    print "g wing"
    for (j = 0; j < m; ++j)
    {
        for (i = 0; i < 2*n; ++i)
        {
            print "f", label(i, j), label(i, j + 1), label(i + 1, j + 1)
            print "f", label(i, j), label(i + 1, j + 1), label(i + 1, j)
        }
    }

    # The tip, between points above each other
    print "f", label(0, m), label(2*n - 1, m), label(1, m)
    for (i = 1; i < n - 1; ++i)
    {
        print "f", label(i, m), label(2*n - i, m), label(i + 1, m)
        print "f", label(i + 1, m), label(2*n - i, m), label(2*n - i - 1, m)
    }
    print "f", label(n - 1, m), label(n + 1, m), label(n, m)
}
