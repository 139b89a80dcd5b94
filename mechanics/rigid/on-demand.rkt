#lang racket/base
;; Rigid bodies, loaded when one of their procedures is first called.

(require "../generic/on-demand.rkt")

(provide-on-demand
 ["rotation.rkt" rotate-x-matrix rotate-y-matrix rotate-z-matrix
                 rotate-x-tuple rotate-y-tuple rotate-z-tuple
                 angle-axis->rotation-matrix 3vector-components->antisymmetric verify-rotation]
 ["angular-velocity.rkt" M-of-q->omega-of-t M-of-q->omega-body-of-t M->omega M->omega-body
                         antisymmetric->column-matrix m:antisymmetric? wcross->w]
 ["Euler-angles.rkt" Euler->M M->Euler Euler->omega Euler->omega-body
                     Euler-state->omega-body Euler-state->omega-space]
 ["body.rkt" T-body L-body L-space T-body-Euler L-body-Euler L-space-Euler rigid-sysder]
 ["quaternion-rotation.rkt" angle-axis->quaternion quaternion->angle-axis quaternion->RM
                            quaternion->rotation-matrix rotation-matrix->quaternion
                            quaternion->4x4 4x4->quaternion q:rotate]
 ["quaternion-state.rkt" quaternion-state->omega-body quaternion-state->omega-space
                         T-quaternion-state qw-sysder qw-state->L-body qw-state->L-space
                         Euler-equations]
 ["inertia.rkt" inertia-tensor parallel-axes principal-moments principal-axes
                box-inertia ball-inertia shell-inertia rod-inertia ellipsoid-inertia
                cylinder-inertia cone-inertia torus-inertia]
 ["density.rkt" density->body body? body-mass body-center body-inertia]
 ["top.rkt" V_eff top-potential nutation-range steady-precessions critical-spin]
 ["spin-orbit.rkt" L-spin-orbit spin-orbit-sysder out-of-roundness])
