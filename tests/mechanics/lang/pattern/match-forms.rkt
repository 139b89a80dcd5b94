#lang racket/base
;; The forms of racket/match as mechanics provides them: the same, loaded at the first use.

(require "../../support/checks.rkt")

(define-namespace-anchor here)

(define (fresh)
  (define space (namespace-anchor->empty-namespace here))
  (parameterize ([current-namespace space]) (namespace-require 'mechanics))
  space)

(define (value-of form [space (fresh)]) (eval form space))

;; All that racket/match provides for programs
(define names-there
  (let-values ([(values forms) (begin (dynamic-require 'racket/match (void))
                                      (module->exports 'racket/match))])
    (for*/list ([exports (list values forms)] [at-0 (in-value (assv 0 exports))]
                #:when at-0 [export (cdr at-0)])
      (car export))))

(define (bound? name space)
  (parameterize ([current-namespace space])
    (and (identifier-binding (namespace-symbol->identifier name)) #t)))

(test-case "every name of racket/match is there"
  (define space (fresh))
  (check-true (> (length names-there) 20))
  (check-equal? (filter (lambda (name) (not (bound? name space))) names-there) '()))

(test-case "each kind of form does what racket/match does"
  (for ([(form value)
         (in-hash
          (hash '(match (up 1 2 (up 3 4)) [(up t q (up a b)) (list t q a b)]) '(1 2 3 4)
                '(match* (1 2) [(x y) #:when (= x 2) 'no] [(x y) (list y x)]) '(2 1)
                '(match 5 [(? odd? n) (=> next) (if (= n 5) (next) 1)] [_ 2]) 2
                '(match 5 [5 (failure-cont)] [_ 'next]) 'next
                '(match/values (values 1 2) [(a b) (- b a)]) 1
                '((match-lambda [(cons a b) b]) '(7 . 8)) 8
                '((match-lambda* [(list a b) a]) 7 8) 7
                '((match-lambda** [(a b) b]) 7 8) 8
                '(match-let ([(list u v) '(4 5)]) (- v u)) 1
                '(match-let* ([(list u v) '(4 5)] [(list w) (list u)]) w) 4
                '(match-letrec ([(list f) (list (lambda (n) (if (= n 0) 'end (f (- n 1)))))]) (f 2))
                'end
                '(match-let-values ([(a b) (values 1 2)]) b) 2
                '(let () (match-define (up a b) (up 1 2)) b) 2
                '(let () (match-define-values ((list a) b) (values '(1) 2)) a) 1
                '(let () (define/match (f x) [((list _ y)) y] [(_) 'no]) (f '(1 2))) 2
                '(match 3 [(== 3) 'three] [_ 'other]) 'three
                '(let () (struct point (x y)) (match (point 1 2) [(struct* point ([y b])) b])) 2
                '(let () (define-match-expander twice (syntax-rules () [(_ p) (list p p)]))
                   (match '(1 1) [(twice a) a])) 1))])
    (check-equal? (list form (value-of form)) (list form value))))

(test-case "in a module, and where racket/match is required over the language"
  (for ([requires '(() ((require racket/match)))] [n (in-naturals)])
    (define name (string->symbol (format "matching~a" n)))
    (define space (fresh))
    (value-of `(module ,name mechanics ,@requires (provide v)
                 (match-define (up a _) (up 1 2))
                 (define v (match (down a 3) [(down p q) (list p q)])))
              space)
    (check-equal? (parameterize ([current-namespace space]) (dynamic-require `',name 'v))
                  '(1 3))))

(test-case "mistakes are told in the words of racket/match"
  (check-exn #rx"match: no matching clause for 3" (lambda () (value-of '(match 3 [4 5]))))
  (check-exn #rx"match: bad syntax" (lambda () (value-of 'match)))
  (check-exn #rx"match.*clause" (lambda () (value-of '(match 3 4)))))
