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
(* Functions of several variables.  Along a path each of them becomes a function of one variable,
   whose derivative is known. *)
Ltac head_of u := lazymatch u with ?f _ => head_of f | _ => u end.
Ltac first_argument u :=
  lazymatch u with ?f ?a => lazymatch f with _ _ => first_argument f | _ => a end end.
Ltac of_several s e use :=
  match e with
  | context [?f ?a ?b] =>
      let h := head_of f in is_var h;
      lazymatch type of (f a b) with R => idtac end;
      lazymatch constr:(f a b) with context [s] => idtac end;
      first [of_several s f use | of_several s a use | of_several s b use | use (f a b)]
  end.
Ltac path_derivative :=
  first [ match goal with H : is_derive ?f ?x _ |- is_derive ?f ?x _ => exact H end
        | auto_derive; [conditions | derivatives_known; reflexivity] ].
Ltac by_paths :=
  match goal with
  | H : ?known |- is_derive ?f ?t _ =>
      let value := eval cbv beta in (f t) in
      let function := head_of value in
      let g := first_argument known in
      constr_eq g function;
      eapply H; lazymatch goal with
                | |- is_derive _ _ _ => path_derivative
                | |- _ => first [reflexivity | ring]
                end
  end.
Ltac along_paths :=
  repeat match goal with
  | |- is_derive ?f ?t ?d =>
      let path := constr:(fun s : R => ltac:(
        let e := eval cbv beta in (f s) in of_several s e ltac:(fun u => exact u))) in
      let along := fresh "along" in
      pose (along := path);
      eassert (is_derive along t _) by (unfold along; by_paths);
      let g := constr:(fun s : R => ltac:(
        let e := eval cbv beta in (f s) in let u := eval cbv beta in (path s) in
        match e with context C [u] => let r := context C [along s] in exact r end)) in
      change (is_derive g t d)
  end.
Ltac paths_back :=
  repeat match goal with along := fun _ : R => _ |- _ => subst along end; cbv beta.

Ltac polynomial_derivative := auto_derive; [exact I | field].
Ltac polynomial_derivatives :=
  hnf; intros;
  auto_derive;
  [ conditions
  | derivatives_known; repeat match goal with H : _ = _ |- _ => rewrite H end; field ].

(* At the numbers of an example *)
Lemma derivative_as : forall (f : R -> R) (x a b : R), is_derive f x a -> a = b -> is_derive f x b.
Proof. intros f x a b H E. rewrite <- E. exact H. Qed.
Ltac numbers_equal :=
  cbv beta; first [ reflexivity | lra | field; at_numbers | field_simplify_eq; at_numbers ].
Ltac conditions_at_numbers :=
  cbv beta; repeat match goal with |- _ /\ _ => split end;
  first [ exact I | derivative_there | eexists; polynomial_derivative | at_numbers ].
