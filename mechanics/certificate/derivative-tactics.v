(* Derivatives, by Coquelicot's is_derive *)

Lemma same_derivative : forall (f : R -> R) (x a b : R),
  is_derive f x a -> is_derive f x b -> a - b = 0.
Proof.
  intros f x a b A B.
  rewrite <- (is_derive_unique f x a A), <- (is_derive_unique f x b B). ring.
Qed.

(* Through each place, with each velocity and acceleration, there is a path. *)
Lemma path_through : forall x v a t : R, exists path velocity : R -> R,
  path t = x /\ velocity t = v /\ is_derive path t v /\ is_derive velocity t a.
Proof.
  intros x v a t.
  exists (fun s => x + v * (s - t) + a / 2 * (s - t) ^ 2), (fun s => v + a * (s - t)).
  refine (conj _ (conj _ (conj _ _))); try ring; (auto_derive; [exact I | field]).
Qed.

(* What the derivative of a function asks for. *)
Ltac derivative_there :=
  match goal with
  | H : is_derive ?f ?x ?d |- ex_derive ?g ?x => exists d; exact H
  end.
Ltac conditions :=
  repeat match goal with |- _ /\ _ => split end;
  first [ exact I | derivative_there | positive | nonzero ].
Ltac derivatives_known :=
  repeat match goal with
  | H : is_derive ?f ?x ?d |- context [Derive ?g ?x] =>
      replace (Derive g x) with d by (symmetry; exact (is_derive_unique g x d H))
  end.
Ltac polynomial_derivative := auto_derive; [exact I | field].

(* At the numbers of an example *)
Lemma derivative_as : forall (f : R -> R) (x a b : R), is_derive f x a -> a = b -> is_derive f x b.
Proof. intros f x a b H E. rewrite <- E. exact H. Qed.
Ltac numbers_equal :=
  cbv beta; first [ reflexivity | lra | field; at_numbers | field_simplify_eq; at_numbers ].
Ltac conditions_at_numbers :=
  cbv beta; repeat match goal with |- _ /\ _ => split end;
  first [ exact I | derivative_there | eexists; polynomial_derivative | at_numbers ].
