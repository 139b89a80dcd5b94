"""@DEFINITION@

For JAX, in 64 bits; `evolve` and `evolve_steps` go through jit, vmap and grad:

    states = jax.vmap(lambda y, p: evolve(y, p, 10.0))(starts, parameters)

States are rows of the variables; p is a row of the parameters.
"""

from functools import partial

import jax

jax.config.update("jax_enable_x64", True)

import jax.numpy as jnp
import jax.scipy.special
from jax import lax

INFINITY = jnp.inf
NAN = jnp.nan

variables = @VARIABLES@
parameters = @PARAMETERS@
first_is_time = @CLOCK@


def _wrapped(x, low, cut, period):
    y = x - period * jnp.floor((x - low) / period)
    inside = (low <= x) & (x < cut)
    return jnp.where(inside, x, jnp.where((y < low) | (y >= cut), low, y))


def derivative(y, p):
    """How fast each variable changes."""
@BODY@

@partial(jax.jit, static_argnums=3)
def evolve_steps(y, p, t, steps):
    """The state at t after so many equal steps of Runge and Kutta's method of order 4.

    The time where it begins is the first variable, where that is the time; otherwise 0."""
    h = (t - (y[0] if first_is_time else 0.0)) / steps

    def step(y, _):
        k1 = derivative(y, p)
        k2 = derivative(y + 0.5 * h * k1, p)
        k3 = derivative(y + 0.5 * h * k2, p)
        k4 = derivative(y + h * k3, p)
        return y + h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4), None

    return _at(t, lax.scan(step, jnp.asarray(y, jnp.float64), None, length=steps)[0])


def _at(t, y):
    """The time of a state is what was asked for, without rounding."""
    return y.at[0].set(t) if first_is_time else y


# The method of Dormand and Prince of order 5: where slopes are taken, and what the error is.
_A = @STAGES@
_E = @ERROR@


def _try(y, k1, p, h):
    ks = [k1]
    for row in _A:
        new = y + h * sum(a * k for a, k in zip(row, ks))
        ks.append(derivative(new, p))
    error = h * sum(e * k for e, k in zip(_E, ks))
    scale = 1.0 + jnp.maximum(jnp.abs(y), jnp.abs(new))
    return new, ks[-1], jnp.sqrt(jnp.mean((error / scale) ** 2))


@jax.jit
def evolve(y, p, t, tolerance=1e-10, most=1000000):
    """The state at t, by steps as long as the tolerance allows; nan if more than `most` are needed.

    Derivatives are taken forwards (jax.jacfwd, jvp); for reverse ones use evolve_steps."""
    y = jnp.asarray(y, jnp.float64)
    start = y[0] if first_is_time else jnp.float64(0.0)
    sign = jnp.where(t < start, -1.0, 1.0)
    tolerated = jnp.maximum(1e-15, 0.1 * tolerance)

    def unfinished(s):
        done, _, _, _, count = s
        return (done < jnp.abs(t - start)) & (count < most)

    def step(s):
        done, h, y, k1, count = s
        left = jnp.abs(t - start) - done
        length = jnp.minimum(h, left)
        new, slope, error = _try(y, k1, p, sign * length)
        error = error / tolerated
        good = error <= 1.0
        growth = jnp.where(error == 0.0, 6.0, 0.9 * error ** -0.2)
        growth = jnp.where(jnp.isnan(growth), 0.2, jnp.clip(growth, 0.2, 6.0))
        reached = jnp.where(length >= left, jnp.abs(t - start), done + length)
        return (jnp.where(good, reached, done), length * growth,
                jnp.where(good, new, y), jnp.where(good, slope, k1), count + 1)

    k1 = derivative(y, p)
    first = jnp.minimum(1e-3, jnp.abs(t - start))
    done, _, y, _, _ = lax.while_loop(unfinished, step,
                                      (jnp.float64(0.0), first, y, k1, jnp.int64(0)))
    return jnp.where(done < jnp.abs(t - start), NAN, _at(t, y))
